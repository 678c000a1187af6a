// Where an output goes that can't be written where it was asked for.
#include "lxs/host/rescue.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <system_error>
#include <vector>

#include "lxs/imaging/file_name.h"

namespace lxs {
namespace {

namespace fs = std::filesystem;

/// The nearest folder on the way to `path` that is there.
fs::path surviving_folder(const fs::path& path) {
    std::error_code error;
    fs::path folder = fs::absolute(path, error).parent_path();
    while (!fs::is_directory(folder, error) && folder.has_relative_path())
        folder = folder.parent_path();
    return folder;
}

std::vector<fs::path> rescue_folders(const fs::path& path) {
    std::error_code error;
    std::vector<fs::path> folders;
    for (const fs::path& folder :
         {surviving_folder(path), fs::current_path(error), fs::temp_directory_path(error)}) {
        const fs::path real = fs::canonical(folder, error);
        if (!error && std::find(folders.begin(), folders.end(), real) == folders.end()) {
            folders.push_back(real);
        }
    }
    return folders;
}

/// A name that is not taken: nothing is overwritten that nobody asked to replace.
fs::path free_name(const fs::path& folder, const fs::path& path) {
    const std::string suffix = path.extension().string();
    const auto named = [&](const std::string& rescued) {
        const std::string end = rescued + suffix;
        const std::size_t longest = longest_name(folder);
        const std::size_t room = longest - std::min(longest, end.size());
        return folder / (cut_name(path.stem().string(), room) + end);
    };
    fs::path name = named(".rescued");
    std::error_code error;
    for (int number = 2; fs::exists(fs::symlink_status(name, error)); ++number)
        name = named(fmt::format(".rescued-{}", number));
    return name;
}

/// Why `write` fails for `path`; empty if it does not.
std::string failure_of(const WriteFile& write, const std::string& path) {
    try {
        write(path);
        return {};
    } catch (const std::bad_alloc&) {
        return fmt::format("cannot write '{}': out of memory", path);
    } catch (const std::exception& error) {
        return error.what();
    }
}

}  // namespace

bool write_or_rescue(const std::string& path, const WriteFile& write, ConsoleLog& log) {
    const std::string failure = failure_of(write, path);
    if (failure.empty()) return true;
    log.error(failure);
    for (const fs::path& folder : rescue_folders(path)) {
        const std::string name = free_name(folder, path).string();
        if (!failure_of(write, name).empty()) continue;
        log.warning(fmt::format("saved as '{}' instead", name));
        return false;
    }
    log.error(fmt::format("'{}' could not be saved anywhere else either", path));
    return false;
}

}  // namespace lxs
