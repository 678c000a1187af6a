// A folder for the files of one test.
#pragma once

#include <filesystem>
#include <string>

namespace lxs::test {

/// Made empty, removed with everything in it at the end.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Writes a file into the folder; returns its path.
    std::string write(const std::string& name, const std::string& text) const;
    /// Content of a file in the folder; the test fails if there is none.
    std::string read(const std::string& name) const;
    bool has(const std::string& name) const;
    std::size_t files() const;

  private:
    std::filesystem::path path_;
};

}  // namespace lxs::test
