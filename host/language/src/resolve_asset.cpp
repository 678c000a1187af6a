// Where the files that a scene names are looked for.
#include <algorithm>
#include <filesystem>

#include "lxs/language/read_scene.h"

namespace lxs {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

/// The file `name` as given, then its last component in the main folder, then as given from the
/// including file's folder.
std::vector<fs::path> candidates(const fs::path& name, const fs::path& main_directory,
                                 const SourceLocation& where) {
    std::vector<fs::path> paths{main_directory / name, main_directory / name.filename()};
    if (where.file) paths.push_back(fs::path(where.file->name).parent_path() / name);
    return paths;
}

}  // namespace

std::string resolve_asset(const std::string& name, const std::string& main_directory,
                          const SourceLocation& where) {
    if (name.empty()) throw InputError(where, "the file name is empty");
    std::vector<fs::path> paths = candidates(name, main_directory, where);
    if (name.find('\\') != std::string::npos) {  // written on Windows
        std::string forward = name;
        std::replace(forward.begin(), forward.end(), '\\', '/');
        const std::vector<fs::path> more = candidates(forward, main_directory, where);
        paths.insert(paths.end(), more.begin(), more.end());
    }
    for (const fs::path& path : paths) {
        if (!is_file(path)) continue;
        std::error_code ignored;
        if (!fs::is_regular_file(path, ignored))  // a device may have no end
            throw InputError(where, in_quotes(name) + " is no regular file");
        return path.lexically_normal().string();
    }
    const std::string folder = main_directory.empty() ? "." : main_directory;
    throw InputError(where, "no file " + in_quotes(name) + "; looked in " + in_quotes(folder) +
                                " and beside the file that names it");
}

}  // namespace lxs
