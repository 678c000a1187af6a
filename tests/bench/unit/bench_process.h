// Runs aips-bench as a user would.
#pragma once

#include <string>

#include "temporary_folder.h"

namespace bench::test {

using files::TemporaryFolder;

struct BenchResult {
    int exit_code = -1;
    std::string text;  ///< both standard streams
};

/// `program` with its arguments as a shell reads it; the working folder is `folder`.
BenchResult run_program(const TemporaryFolder& folder, const std::string& program);

/// `arguments` as a shell reads them; the working folder is `folder`.
BenchResult run_bench(const TemporaryFolder& folder, const std::string& arguments);

}  // namespace bench::test
