// Measures the copy bandwidth.
#include "memory_floor.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <vector>

namespace aips::bench {
namespace {

double measured_copy_rate() {
    constexpr std::size_t kBytes = std::size_t{1} << 27;
    std::vector<char> from(kBytes, 1), to(kBytes, 2);
    double best = 0;
    for (int i = 0; i < 5; ++i) {
        const std::clock_t start = std::clock();
        std::memcpy(to.data(), from.data(), kBytes);
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
        const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
        best = std::max(best, 2 * double(kBytes) / seconds);
    }
    return best;
}

}  // namespace

double copy_bytes_per_second() {
    static const double rate = measured_copy_rate();
    return rate;
}

void report_bytes(benchmark::State& state, std::size_t bytes_per_iteration) {
    state.SetBytesProcessed(state.iterations() * std::int64_t(bytes_per_iteration));
    state.counters["floor_ns"] = 1e9 * double(bytes_per_iteration) / copy_bytes_per_second();
}

}  // namespace aips::bench
