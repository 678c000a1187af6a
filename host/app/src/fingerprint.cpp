// What the bits of an image depend on, so that a render goes on only from a checkpoint of its own.
#include "lxs/host/fingerprint.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/dll/runtime_symbol_info.hpp>
#include <set>
#include <vector>

#include "lxs/host/checksum.h"
#include "lxs/images/image_library.h"
#include "lxs/imaging/image_header.h"
#include "lxs/sdk/plugin.h"

namespace lxs {

void Fingerprint::set_program(const std::filesystem::path& integrator_module) {
    Checksum sum;
    sum.add_text(version() + " " + std::to_string(kAbiVersion));
    sum.add_file(boost::dll::program_location().string());
    sum.add_file(integrator_module.string());
    const std::filesystem::path images = image_library_file();
    if (!images.empty()) sum.add_file(images.string());
    checksums_[Program] = sum.value();
}

void Fingerprint::set_sources(const ReadFiles& files) {
    Checksum sum;
    for (const auto& source : files.sources)
        sum.add_text(*source->text);
    checksums_[Sources] = sum.value();
}

void Fingerprint::set_assets(const ReadFiles& files) {
    std::set<std::string_view> seen;
    std::vector<std::string> paths;
    for (const std::string& path : files.assets) {
        if (seen.insert(path).second) paths.push_back(path);
    }
    Checksum sum;
    sum.add_files(paths);
    checksums_[Assets] = sum.value();
}

void Fingerprint::set_settings(const CommandLine& command, std::string_view integrator,
                               std::uint32_t width, std::uint32_t height) {
    Checksum sum;
    sum.add_text(integrator);
    sum.add_text(command.sampler.value_or(""));
    sum.add_text(std::to_string(width) + " x " + std::to_string(height));
    sum.add_text(command.layers.value_or(""));
    for (const std::string& override : command.overrides)
        sum.add_text(override);
    checksums_[Settings] = sum.value();
}

void Fingerprint::set_seed(std::uint64_t seed) {
    Checksum sum;
    sum.add_text(std::to_string(seed));
    checksums_[Seed] = sum.value();
}

void Fingerprint::set_learned(std::span<const std::byte> file) {
    Checksum sum;
    sum.add(file);
    checksums_[Learned] = sum.value();
}

void Fingerprint::describe(ImageMetadata& metadata) const {
    const auto text = [&](Cause cause) { return fmt::format("{:016x}", checksums_[cause]); };
    metadata[image_header::kSceneText] = text(Sources);
    metadata[image_header::kSceneFiles] = text(Assets);
    metadata[image_header::kSettings] = text(Settings);
}

std::string Fingerprint::difference(const Fingerprint& other) const {
    static constexpr std::array<std::string_view, Causes> kNames = {
        "the build of lxsrender or of the integrator's module",
        "the text of the scene",
        "a mesh, texture or other file that the scene names",
        "the integrator, a setting or the size of the image",
        "the seed",
        "what was learned before",
    };
    std::string text;
    for (std::size_t cause = 0; cause < Causes; ++cause) {
        if (checksums_[cause] == other.checksums_[cause]) continue;
        text += text.empty() ? "" : ", ";
        text += kNames[cause];
    }
    return text;
}

}  // namespace lxs
