// Loops of known sizes, each of which must work on all of its items once: exit code 1 otherwise.
// They are gone through once, or as many times as there are arguments. work_record_test.py looks at
// their record.
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

namespace {

bool all_once(const std::vector<int>& times) {
    for (const int t : times) {
        if (t != 1) return false;
    }
    return true;
}

bool numbered_items() {
    std::vector<int> times(10);
    tbb::parallel_for(0u, 10u, [&](std::uint32_t i) { ++times[i]; });
    return all_once(times);
}

bool ranges() {
    std::vector<int> times(1000);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, times.size(), 256),
                      [&](const auto& range) {
                          for (std::size_t i = range.begin(); i != range.end(); ++i)
                              ++times[i];
                      });
    return all_once(times);
}

bool many_items() {
    std::vector<int> times(100'000);
    tbb::parallel_for(std::size_t{0}, times.size(), [&](std::size_t i) { ++times[i]; });
    return all_once(times);
}

bool loops_within() {
    std::atomic<int> times{0};
    const std::function<void(std::uint32_t)> job = [&](std::uint32_t /*i*/) {
        tbb::parallel_for(0, 5, [&](int /*i*/) { ++times; });
    };
    tbb::parallel_for(0u, 3u, job);
    return times == 15;
}

bool beside_each_other() {
    std::atomic<int> times{0};
    const auto work = [&] { tbb::parallel_for(0, 5, [&](int /*i*/) { ++times; }); };
    tbb::parallel_invoke(work, [&] { tbb::parallel_invoke(work, work); });
    tbb::parallel_invoke([&] { ++times; }, [&] { ++times; });
    return times == 17;
}

bool no_items() {
    tbb::parallel_for(3, 3, [](int /*i*/) {});
    return true;
}

}  // namespace

int main(int argc, char** /*argv*/) {
    bool right = true;
    for (int i = 0; i < std::max(1, argc - 1); ++i)
        right = right && numbered_items() && ranges() && many_items() && loops_within() &&
                beside_each_other() && no_items();
    return right ? 0 : 1;
}
