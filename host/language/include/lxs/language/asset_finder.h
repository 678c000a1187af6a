// Where the files that a scene names are.
#pragma once

#include <filesystem>
#include <string>
#include <unordered_map>
#include <vector>

#include "lxs/sdk/diagnostics.h"

namespace lxs {

/// What folders hold, read once each: a scene may name thousands of files that are not there.
class FolderListings {
  public:
    /// Names in `folder` that differ from `name` in upper and lower case alone, sorted.
    std::vector<std::string> like(const std::filesystem::path& folder, const std::string& name);

  private:
    using Names = std::unordered_map<std::string, std::vector<std::string>>;  ///< by lower case
    const Names& names_in(const std::filesystem::path& folder);

    std::unordered_map<std::string, Names> folders_;
    std::size_t names_ = 0;  ///< in all of them
};

/// Finds files for one scene; not from several threads at once.
class AssetFinder {
  public:
    /// `main_directory`: the folder of the main scene.
    explicit AssetFinder(std::string main_directory) : main_directory_(std::move(main_directory)) {}

    const std::string& main_directory() const { return main_directory_; }
    /// Path of an asset named in a scene: against the main scene's folder, then its basename there,
    /// then the including file's folder; then the same, whatever the letter case, which is
    /// reported. Throws InputError at `where` if none exists.
    std::string find(const std::string& name, const SourceLocation& where,
                     Diagnostics& diagnostics);

  private:
    std::string main_directory_;
    FolderListings listings_;
};

}  // namespace lxs
