// Runs the files of the named folders through a fuzz target: the corpora and the found cases, in
// any build and with any compiler.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz_target.h"

namespace {

namespace fs = std::filesystem;

/// Beyond these a case counts as a hang. A sanitized fuzzer has as much for its own inputs.
constexpr double kMostSeconds = 10;

std::vector<fs::path> files_of(const fs::path& folder) {
    std::vector<fs::path> files;
    if (!fs::is_directory(folder)) return {folder};
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

bool replay(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file.is_open()) {
        std::fprintf(stderr, "%s can't be read\n", path.c_str());
        return false;
    }
    // Named before it is run: the last name is that of the case that crashed.
    std::fprintf(stderr, "%s\n", path.c_str());
    const auto start = std::chrono::steady_clock::now();
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (seconds <= kMostSeconds) return true;
    std::fprintf(stderr, "%s took %g s, more than %g\n", path.c_str(), seconds, kMostSeconds);
    return false;
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t count = 0;
    bool good = true;
    for (int i = 1; i < argc; ++i) {
        for (const fs::path& path : files_of(argv[i])) {
            good &= replay(path);
            ++count;
        }
    }
    std::printf("%zu inputs replayed\n", count);
    return good && count > 0 ? 0 : 1;
}
