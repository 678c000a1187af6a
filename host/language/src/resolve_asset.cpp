// Where the files that a scene names are looked for.
#include <algorithm>
#include <cctype>
#include <filesystem>

#include "lxs/language/read_scene.h"

namespace lxs {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

bool same_but_for_case(const std::string& a, const std::string& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
        return std::tolower(x) == std::tolower(y);
    });
}

/// What `folder` holds by the name `part`, or by one that differs from it in upper and lower case;
/// empty if there is nothing.
fs::path entry_like(const fs::path& folder, const fs::path& part) {
    std::error_code error;
    if (fs::exists(folder / part, error)) return folder / part;
    std::vector<fs::path> found;
    fs::directory_iterator entry(folder.empty() ? "." : folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        if (same_but_for_case(entry->path().filename().string(), part.string()))
            found.push_back(folder / entry->path().filename());
    }
    return found.empty() ? fs::path() : *std::min_element(found.begin(), found.end());
}

/// The file that `path` means but for upper and lower case; empty if there is none.
fs::path file_like(const fs::path& path) {
    fs::path found = path.root_path();
    for (const fs::path& part : path.relative_path()) {
        found = entry_like(found, part);
        if (found.empty()) return {};
    }
    return is_file(found) ? found : fs::path();
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
                          const SourceLocation& where, Diagnostics& diagnostics) {
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
    for (const fs::path& path : paths) {
        std::error_code ignored;
        const fs::path like = file_like(path.lexically_normal());
        if (like.empty() || !fs::is_regular_file(like, ignored)) continue;
        diagnostics.fallback(where,
                             "no file " + in_quotes(name) + ", but " + in_quotes(like.string()) +
                                 ", of other letter case",
                             "that one is read");
        return like.string();
    }
    const std::string folder = main_directory.empty() ? "." : main_directory;
    throw InputError(where, "no file " + in_quotes(name) + "; looked in " + in_quotes(folder) +
                                " and beside the file that names it");
}

}  // namespace lxs
