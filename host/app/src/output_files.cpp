// Where the outputs of a render go.
#include "lxs/host/output_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <boost/algorithm/string/predicate.hpp>
#include <cerrno>
#include <filesystem>
#include <locale>
#include <new>
#include <system_error>

#include "lxs/host/failure.h"
#include "lxs/host/rescue.h"
#include "lxs/imaging/atomic_file.h"

namespace lxs {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, int error) {
    throw OutputFailure(
        fmt::format("cannot write '{}': {}", path, std::generic_category().message(error)));
}

/// Permissions alone don't tell (read-only mounts, root): only a file that was made does.
void check_folder_of(const std::string& path) {
    if (fs::is_directory(path)) fail(path, EISDIR);
    const fs::path folder = fs::path(path).parent_path();
    std::string probe = ((folder.empty() ? "." : folder) / ".lxsrender-XXXXXX").string();
    const int descriptor = ::mkstemp(probe.data());
    if (descriptor < 0) fail(path, errno);
    ::close(descriptor);
    ::unlink(probe.c_str());
}

}  // namespace

bool has_suffix(const std::string& name, const std::string& suffix) {
    return boost::iequals(fs::path(name).extension().string(), suffix, std::locale::classic());
}

OutputFiles choose_output_files(const CommandLine& command, const FileFilm& film) {
    OutputFiles files;
    const std::string name = command.output ? *command.output : film.base_name() + ".exr";
    if (has_suffix(name, ".png")) {
        files.png = name;
    } else {
        files.exr = name;
        files.png = fs::path(name).replace_extension(".png").string();
    }
    files.statistics = command.statistics.value_or("");
    return files;
}

void check_writable(const std::string& path) {
    check_folder_of(path);
    remove_abandoned_temporaries(path);
}

void check_writable(const OutputFiles& files) {
    for (const std::string& path : {files.exr, files.png, files.statistics}) {
        if (!path.empty()) check_writable(path);
    }
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
