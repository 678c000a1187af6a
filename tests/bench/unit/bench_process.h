// Runs aips-bench as a user would, in a folder that goes away with the test.
#pragma once

#include <filesystem>
#include <string>

#include "study_file.h"

namespace bench::test {

class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }
    void write(const std::string& name, const std::string& text) const;

  private:
    std::filesystem::path path_;
};

struct BenchResult {
    int exit_code = -1;
    std::string text;  ///< both standard streams
};

/// `program` with its arguments as a shell reads it; the working folder is `folder`.
BenchResult run_program(const TemporaryFolder& folder, const std::string& program);

/// `arguments` as a shell reads them; the working folder is `folder`.
BenchResult run_bench(const TemporaryFolder& folder, const std::string& arguments);

}  // namespace bench::test
