// Where the outputs of a render go.
#include "lxs/host/output_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <filesystem>
#include <locale>
#include <new>
#include <system_error>

#include "lxs/host/failure.h"
#include "lxs/host/rescue.h"
#include "lxs/imaging/atomic_file.h"
#include "lxs/imaging/file_name.h"
#include "lxs/sdk/diagnostics.h"

namespace lxs {
namespace {

namespace fs = std::filesystem;

/// A scene says what its image is called, and whoever renders it where files go: `name` without its
/// folder, if that is not below the current one.
std::string below_current_folder(const std::string& name, ConsoleLog& log) {
    std::string forward = name;
    std::ranges::replace(forward, '\\', '/');  // written on Windows
    const bool has_drive = forward.size() > 1 && forward[1] == ':';
    const fs::path path = fs::path(forward).lexically_normal();
    if (!has_drive && path.is_relative() && *path.begin() != "..") return path.string();
    std::string last = path.filename().string();
    if (last.empty() || last == "..") last = "luxout";
    log.warning(
        fmt::format("the film's filename {} is not below the current folder: {} is written there; "
                    "-o names any other place",
                    in_quotes(name), in_quotes(last)));
    return last;
}

/// The same of links: a folder may come with the scene, and links in it.
void check_below_current_folder(const std::string& path) {
    std::error_code error;
    const fs::path target = follow_links(path, error);
    const fs::path folder =
        fs::canonical(target.has_parent_path() ? target.parent_path() : ".", error);
    if (error) return;  // as writing will tell
    const fs::path current = fs::canonical(".", error);
    if (std::ranges::mismatch(current, folder).in1 == current.end()) return;
    throw OutputFailure(
        fmt::format("cannot write '{}', which the film names: links lead from there to '{}', out "
                    "of the current folder; -o names any place",
                    path, (folder / target.filename()).string()));
}

}  // namespace

bool has_suffix(const std::string& name, const std::string& suffix) {
    return boost::iequals(fs::path(name).extension().string(), suffix, std::locale::classic());
}

OutputFiles choose_output_files(const CommandLine& command, const FileFilm& film, ConsoleLog& log) {
    OutputFiles files;
    const std::string name =
        command.output ? *command.output : below_current_folder(film.base_name(), log) + ".exr";
    if (has_suffix(name, ".png")) {
        files.png = name;
    } else {
        files.exr = name;
        files.png = fs::path(name).replace_extension(".png").string();
    }
    if (!command.output) {
        check_below_current_folder(files.exr);
        check_below_current_folder(files.png);
    }
    files.statistics = command.statistics.value_or("");
    return files;
}

void check_writable(const std::string& path, ConsoleLog& log) {
    if (path.empty()) return;
    try {
        // Permissions alone don't tell (read-only mounts, root): only a file that was made does.
        if (const std::error_code no_lock = probe_atomic_file(path)) {
            log.warning(
                fmt::format("files beside '{}' can't be locked: {}; what a killed process leaves "
                            "of its writing will stay there",
                            path, no_lock.message()));
        }
    } catch (const std::runtime_error& error) {
        throw OutputFailure(error.what());
    }
    remove_abandoned_temporaries(path);
}

std::string names_of_images(const OutputFiles& files) {
    return files.exr.empty() ? files.png : fmt::format("{} and {}", files.exr, files.png);
}

bool write_images(const OutputFiles& files, const FileFilm& film, const ImageMetadata& metadata,
                  ConsoleLog& log) {
    std::vector<Rgb> denoised;
    try {
        denoised = film.denoised();
    } catch (const std::bad_alloc&) {
        log.error("the image is not denoised: there is not enough memory");
    }
    const auto write_exr = [&](const std::string& path) {
        film.write_exr(path, metadata, denoised);
    };
    const auto write_png = [&](const std::string& path) { film.write_png(path, denoised); };
    const bool exr = files.exr.empty() || write_or_rescue(files.exr, write_exr, log);
    const bool png = files.png.empty() || write_or_rescue(files.png, write_png, log);
    return exr && png;
}

}  // namespace lxs
