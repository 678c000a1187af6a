// Folder, registry and assets for fuzz targets.
#include "input_files.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "lxs/scene/constant_texture.h"

namespace fuzz {
namespace {

constexpr const char* kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 "
    "0 1 2\n";
constexpr const char* kStl =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid s\n";
constexpr const char* kIes =
    "IESNA:LM-63-1995\nTILT=NONE\n1 1000 1 3 1 1 2 0 0 0 1 1 50\n0 45 90\n0\n100 50 0\n";
constexpr const char* kMetal = "400 1.5 2.5\n550 1.2 2.8\n700 0.9 3.1\n";
constexpr const char* kSpectrum = "380 0.1\n550 0.9\n720 0.4\n";

constexpr double kMostLevels = 3;

/// A shape's factory that splits triangles three times at most: ten million triangles are allowed,
/// but one statement would then take seconds and a gigabyte (docs/build-on/testing.md).
lxs::ShapeFactory with_few_levels(const lxs::ShapeFactory& factory) {
    const auto create = [factory](const lxs::ParameterReader& reader,
                                  const lxs::AssetContext& assets, const lxs::Matrix& to_world) {
        lxs::ParameterSet set = reader.set();
        // Displacement by default asks for six levels.
        if (reader.given("displacementmap") && !reader.given("nsubdivlevels")) {
            set.values.push_back(
                {"integer", "nsubdivlevels", std::vector<double>{9}, somewhere(), {}});
        }
        for (lxs::ParameterValue& value : set.values) {
            auto* numbers = std::get_if<std::vector<double>>(&value.values);
            if (!numbers || !value.name.ends_with("levels")) continue;
            for (double& number : *numbers)
                number = std::min(number, kMostLevels);
        }
        SilentDiagnostics diagnostics;
        return factory.create({set, factory.parameters, diagnostics}, assets, to_world);
    };
    return {factory.parameters, create};
}

void write_image(const std::string& path) {
    const unsigned char pixels[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
    const auto image = OIIO::ImageOutput::create(path);
    image->open(path, OIIO::ImageSpec(2, 2, 3, OIIO::TypeDesc::UINT8));
    image->write_image(OIIO::TypeDesc::UINT8, pixels);
    image->close();
}

}  // namespace

void SilentDiagnostics::warning(const lxs::SourceLocation& where, const std::string& message) {
    check_message(lxs::format_message(where, "warning", message));
}

void SilentDiagnostics::unknown_parameter(const lxs::SourceLocation& where,
                                          const std::string& message) {
    warning(where, message);
}

void SilentDiagnostics::fallback(const lxs::SourceLocation& where, const std::string& message,
                                 const std::string& instead) {
    warning(where, message + "; " + instead);
}

void SilentDiagnostics::error(const lxs::InputError& error) {
    check_message(error.what());
}

const lxs::Registry& registry() {
    static const lxs::Registry all = [] {
        lxs::Registry made;
        register_shapes(made);
        for (auto& [name, factory] : made.shapes)
            factory = with_few_levels(factory);
        register_shading(made);
        return made;
    }();
    return all;
}

const files::TemporaryFolder& folder() {
    static const files::TemporaryFolder made;
    static const bool filled = [] {
        made.write("mesh.ply", kPly);
        made.write("mesh.stl", kStl);
        made.write("lamp.ies", kIes);
        made.write("metal.nk", kMetal);
        made.write("light.spd", kSpectrum);
        write_image(made / "image.png");
        return true;
    }();
    static_cast<void>(filled);
    return made;
}

std::string FuzzAssets::resolve(const std::string& name, const lxs::SourceLocation& where) const {
    if (name.empty() || name.find('/') != std::string::npos ||
        name.find('\0') != std::string::npos || !folder().has(name))
        throw lxs::InputError(where, "no file " + lxs::in_quotes(name));
    return folder() / name;
}

std::shared_ptr<const lxs::FloatTexture> FuzzAssets::float_texture(
    const std::string& name, const lxs::SourceLocation&) const {
    return std::make_shared<lxs::ConstantTexture<float>>(static_cast<float>(name.size()) / 4);
}

std::shared_ptr<const lxs::ColorTexture> FuzzAssets::color_texture(
    const std::string& name, const lxs::SourceLocation&) const {
    return std::make_shared<lxs::ConstantTexture<lxs::Rgb>>(
        lxs::Rgb(static_cast<float>(name.size()) / 4));
}

std::shared_ptr<const lxs::FresnelTexture> FuzzAssets::fresnel_texture(
    const std::string& name, const lxs::SourceLocation&) const {
    lxs::FresnelValue value;
    value.conductor = name.size() % 2 == 1;
    value.k = lxs::Rgb(value.conductor ? 2.0f : 0.0f);
    return std::make_shared<lxs::ConstantTexture<lxs::FresnelValue>>(value);
}

std::shared_ptr<const lxs::Material> FuzzAssets::material(const std::string& name,
                                                          const lxs::SourceLocation& where) const {
    lxs::ParameterSet set;
    set.plugin = name.size() % 2 == 1 ? "glass" : "matte";
    set.where = where;
    SilentDiagnostics diagnostics;
    const auto& factory = registry().materials.at(set.plugin);
    const lxs::ParameterReader reader(set, factory.parameters, diagnostics);
    return factory.create(reader, *this, lxs::Matrix());
}

void check_message(std::string_view message) {
    constexpr std::size_t kLongest = 16384;  // names of all known things, and paths
    const auto control = [](char c) {
        return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f;
    };
    if (!message.empty() && message.size() <= kLongest && std::ranges::none_of(message, control))
        return;
    std::fprintf(stderr, "a message of %zu bytes that is none: %.*s\n", message.size(),
                 static_cast<int>(std::min(message.size(), kLongest)), message.data());
    std::abort();
}

lxs::SourceLocation somewhere() {
    static const auto file = [] {
        auto made = std::make_shared<lxs::SourceFile>();
        made->name = "fuzz.lxs";
        return made;
    }();
    return {file, 1, 1};
}

void check_refusal(const std::exception& refusal) {
    check_message(refusal.what());
}

std::string take_files(std::string_view text, std::span<const std::string_view> names,
                       std::vector<std::string>& written) {
    constexpr std::string_view kMark = "\n#file ";
    std::size_t at = text.find(kMark);
    std::string main(text.substr(0, at));
    while (at != std::string_view::npos) {
        const std::size_t name = at + kMark.size();
        const std::size_t line_end = std::min(text.find('\n', name), text.size());
        const std::size_t next = text.find(kMark, line_end);
        const std::size_t begin = std::min(line_end + 1, text.size());
        for (const std::string_view known : names) {
            if (text.substr(name, line_end - name) != known) continue;
            const std::size_t end = std::min(next, text.size());
            written.push_back(
                folder().write(std::string(known),
                               std::string(text.substr(begin, end < begin ? 0 : end - begin))));
        }
        at = next;
    }
    return main;
}

void read_with_files(const std::uint8_t* data, std::size_t size,
                     std::span<const std::string_view> names,
                     const std::function<void(const std::string&, lxs::Diagnostics&)>& read) {
    std::vector<std::string> written;
    const std::string main =
        take_files({reinterpret_cast<const char*>(data), data ? size : 0}, names, written);
    SilentDiagnostics diagnostics;
    try {
        read(main, diagnostics);
    } catch (const lxs::InputError& refusal) {
        check_refusal(refusal);
    }
    for (const std::string& file : written)
        std::filesystem::remove(file);
}

}  // namespace fuzz
