// Runs aips-bench as a user would.
#include "bench_process.h"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <stdexcept>

namespace bench::test {

BenchResult run_bench(const TemporaryFolder& folder, const std::string& arguments) {
    return run_program(folder, std::string("'") + AIPS_BENCH + "' " + arguments);
}

BenchResult run_program(const TemporaryFolder& folder, const std::string& program) {
    const std::string command = "cd '" + folder.path().string() + "' && " + program + " 2>&1";
    std::FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
    BenchResult result;
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
        result.text.append(buffer.data(), count);
    const int status = ::pclose(pipe);
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return result;
}

}  // namespace bench::test
