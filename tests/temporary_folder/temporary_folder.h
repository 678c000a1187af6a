// A folder for the files of one test.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace files {

/// Made empty, removed with everything in it at the end. Throws std::runtime_error where files
/// can't be made, written or read.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Path of `name` in the folder, there or not.
    std::string operator/(const std::string& name) const;
    /// Writes a file into the folder, with the folders on its way; returns its path.
    std::string write(const std::string& name, const std::string& text) const;
    /// Content of a file in the folder.
    std::string read(const std::string& name) const;
    bool has(const std::string& name) const;
    /// Number of files and folders directly in it.
    std::size_t entries() const;

  private:
    std::filesystem::path path_;
};

}  // namespace files
