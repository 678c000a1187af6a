// Where the outputs of a render go.
#include "lxs/host/output_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
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

OutputFiles choose_output_files(const CommandLine& command, const FileFilm& film) {
    OutputFiles files;
    files.exr = command.output ? *command.output : film.base_name() + ".exr";
    files.png = fs::path(files.exr).replace_extension(".png").string();
    files.statistics = command.statistics.value_or("");
    return files;
}

void check_writable(const std::string& path) {
    check_folder_of(path);
    remove_abandoned_temporaries(path);
}

void check_writable(const OutputFiles& files) {
    check_writable(files.exr);
    check_writable(files.png);
    if (!files.statistics.empty()) check_writable(files.statistics);
}

void write_snapshot(const OutputFiles& files, const FileFilm& film, const ImageMetadata& metadata,
                    ConsoleLog& log) {
    try {
        film.write_exr(files.exr, metadata);
        film.write_png(files.png);
    } catch (const std::bad_alloc&) {
        log.warning("no memory to write the image so far; rendering goes on");
    } catch (const std::exception& error) {
        log.warning(
            fmt::format("{}; rendering goes on, and writing is tried again later", error.what()));
    }
}

bool write_images(const OutputFiles& files, const FileFilm& film, const ImageMetadata& metadata,
                  ConsoleLog& log) {
    const auto write_exr = [&](const std::string& path) { film.write_exr(path, metadata); };
    const auto write_png = [&](const std::string& path) { film.write_png(path); };
    const bool exr = write_or_rescue(files.exr, write_exr, log);
    const bool png = write_or_rescue(files.png, write_png, log);
    return exr && png;
}

}  // namespace lxs
