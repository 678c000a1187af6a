// Where the files that a scene names are.
#include "lxs/language/asset_finder.h"

#include <algorithm>
#include <cctype>

namespace lxs {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool is_regular(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

/// A file name and where it is looked for, unless it is absolute.
struct Candidate {
    fs::path folder, name;
    fs::path path() const { return folder / name; }
};

/// Looks for a file whose name is right but for upper and lower case.
class CaseSearch {
  public:
    CaseSearch(const Candidate& wanted, FolderListings& listings)
        : listings_(listings),
          parts_(parts_of(wanted.name.relative_path())),
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
        std::error_code ignored;
        if (fs::exists(folder / parts_[part], ignored)) {
            fs::path file = look_in(folder / parts_[part], part + 1);
            if (!file.empty()) return file;
        }
        for (const std::string& name : listings_.like(folder, parts_[part].string())) {
            fs::path file = look_in(folder / name, part + 1);
            if (!file.empty()) return file;
        }
        return {};
    }

    FolderListings& listings_;
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

const FolderListings::Names& FolderListings::names_in(const fs::path& folder) {
    constexpr std::size_t kMostNames = 1'000'000;  // that are kept
    if (names_ > kMostNames) {
        folders_.clear();
        names_ = 0;
    }
    const auto [known, is_new] = folders_.try_emplace(folder.string());
    if (!is_new) return known->second;
    std::error_code error;
    fs::directory_iterator entry(folder.empty() ? "." : folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        known->second[lower_case(name)].push_back(name);
        ++names_;
    }
    for (auto& [lower, names] : known->second)
        std::ranges::sort(names);
    return known->second;
}

std::vector<std::string> FolderListings::like(const fs::path& folder, const std::string& name) {
    const Names& names = names_in(folder);
    const auto found = names.find(lower_case(name));
    if (found == names.end()) return {};
    std::vector<std::string> others = found->second;
    std::erase(others, name);
    return others;
}

std::string AssetFinder::find(const std::string& name, const SourceLocation& where,
                              Diagnostics& diagnostics) {
    if (name.empty()) throw InputError(where, "the file name is empty");
    std::vector<Candidate> wanted = candidates(name, main_directory_, where);
    if (name.find('\\') != std::string::npos) {  // written on Windows
        std::string forward = name;
        std::replace(forward.begin(), forward.end(), '\\', '/');
        const std::vector<Candidate> more = candidates(forward, main_directory_, where);
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
        const CaseSearch search(candidate, listings_);
        if (search.found().empty()) continue;
        std::string like = tidy(search.found());
        diagnostics.fallback(
            where,
            "no file " + in_quotes(name) + ", but " + in_quotes(like) + ", of other letter case",
            "that one is read");
        return like;
    }
    const std::string folder = main_directory_.empty() ? "." : main_directory_;
    throw InputError(where, "no file " + in_quotes(name) + "; looked in " + in_quotes(folder) +
                                " and beside the file that names it");
}

}  // namespace lxs
