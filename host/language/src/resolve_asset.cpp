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

bool is_regular(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

/// What `folder` holds by the name `part`, then by names that differ from it in upper and lower
/// case, sorted.
std::vector<fs::path> entries_like(const fs::path& folder, const fs::path& part) {
    std::vector<fs::path> found;
    std::error_code error;
    fs::directory_iterator entry(folder.empty() ? "." : folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        const fs::path name = entry->path().filename();
        if (name != part && same_but_for_case(name.string(), part.string()))
            found.push_back(folder / name);
    }
    std::sort(found.begin(), found.end());
    if (fs::exists(folder / part, error)) found.insert(found.begin(), folder / part);
    return found;
}

/// A file name and where it is looked for, unless it is absolute.
struct Candidate {
    fs::path folder, name;
    fs::path path() const { return folder / name; }
};

/// Looks for a file whose name is right but for upper and lower case.
class CaseSearch {
  public:
    explicit CaseSearch(const Candidate& wanted)
        : parts_(parts_of(wanted.name.relative_path())),
          found_(look_in(wanted.name.is_absolute() ? wanted.name.root_path() : wanted.folder, 0)) {}

    /// The first file found; empty if there is none.
    const fs::path& found() const { return found_; }

  private:
    static constexpr int kMostFolders = 1000;  // a path may lead through "..", again and again

    static std::vector<fs::path> parts_of(const fs::path& path) {
        return {path.begin(), path.end()};
    }

    fs::path look_in(const fs::path& folder, std::size_t part) {
        if (part == parts_.size()) return is_regular(folder) ? folder : fs::path();
        if (++folders_ > kMostFolders) return {};
        for (const fs::path& entry : entries_like(folder, parts_[part])) {
            fs::path file = look_in(entry, part + 1);
            if (!file.empty()) return file;
        }
        return {};
    }

    std::vector<fs::path> parts_;
    int folders_ = 0;  ///< looked into
    fs::path found_;
};

/// `path` without "." and "..", unless that leads elsewhere, as it may behind a link.
std::string tidy(const fs::path& path) {
    const fs::path normal = path.lexically_normal();
    std::error_code error;
    return (fs::equivalent(path, normal, error) ? normal : path).string();
}

/// The file `name` as given, then its last component in the main folder, then as given from the
/// including file's folder.
std::vector<Candidate> candidates(const fs::path& name, const fs::path& main_directory,
                                  const SourceLocation& where) {
    std::vector<Candidate> all{{main_directory, name}, {main_directory, name.filename()}};
    if (where.file) all.push_back({fs::path(where.file->name).parent_path(), name});
    return all;
}

}  // namespace

std::string resolve_asset(const std::string& name, const std::string& main_directory,
                          const SourceLocation& where, Diagnostics& diagnostics) {
    if (name.empty()) throw InputError(where, "the file name is empty");
    std::vector<Candidate> wanted = candidates(name, main_directory, where);
    if (name.find('\\') != std::string::npos) {  // written on Windows
        std::string forward = name;
        std::replace(forward.begin(), forward.end(), '\\', '/');
        const std::vector<Candidate> more = candidates(forward, main_directory, where);
        wanted.insert(wanted.end(), more.begin(), more.end());
    }
    for (const Candidate& candidate : wanted) {
        const fs::path path = candidate.path();
        if (!is_file(path)) continue;
        if (!is_regular(path))  // a device may have no end
            throw InputError(where, in_quotes(name) + " is no regular file");
        return tidy(path);
    }
    for (const Candidate& candidate : wanted) {
        const CaseSearch search(candidate);
        if (search.found().empty()) continue;
        std::string like = tidy(search.found());
        diagnostics.fallback(
            where,
            "no file " + in_quotes(name) + ", but " + in_quotes(like) + ", of other letter case",
            "that one is read");
        return like;
    }
    const std::string folder = main_directory.empty() ? "." : main_directory;
    throw InputError(where, "no file " + in_quotes(name) + "; looked in " + in_quotes(folder) +
                                " and beside the file that names it");
}

}  // namespace lxs
