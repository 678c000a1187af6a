// Protects what is reckoned of Embree's build: work and span of tasks with known ones, on a clock
// that the tasks themselves move.
#include "task_span.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>

namespace task_span_test {
namespace {

/// Seconds that were worked.
struct Worked {
    double seconds = 0;
    void work(double more) { seconds += more; }
    task_span::Span measure(const std::function<void()>& body) {
        return task_span::measure(64, body, [this] { return seconds; });
    }
};

void for_each(int count, const std::function<void(int)>& body) {
    tbb::parallel_for(
        tbb::blocked_range<int>(0, count, 1),
        [&](const tbb::blocked_range<int>& range) {
            for (int i = range.begin(); i < range.end(); ++i)
                body(i);
        },
        tbb::simple_partitioner());
}

TEST(TaskSpan, OfSerialWorkIsAllOfIt) {
    Worked clock;
    const auto span = clock.measure([&] { clock.work(3); });
    EXPECT_EQ(span.work, 3);
    EXPECT_EQ(span.span, 3);
    EXPECT_EQ(span.tasks, 0u);
}

TEST(TaskSpan, OfALoopIsItsLongestTask) {
    Worked clock;
    const auto span = clock.measure([&] {
        clock.work(1);
        for_each(100, [&](int i) { clock.work(i == 70 ? 5 : 2); });
        clock.work(1);
        for_each(10, [&](int) { clock.work(1); });
    });
    EXPECT_EQ(span.work, 1 + 99 * 2 + 5 + 1 + 10);
    EXPECT_EQ(span.span, 1 + 5 + 1 + 1);
    EXPECT_EQ(span.on(1), span.work);
    EXPECT_EQ(span.on(10), 8 + (215 - 8) / 10.0);
}

/// As hierarchies are built: both halves at once, each of which has loops of its own.
double halved(Worked& clock, int size) {
    if (size == 1) {
        clock.work(1);
        return 1;
    }
    for_each(size, [&](int) { clock.work(1); });
    double longest = 0;
    tbb::parallel_invoke([&] { longest = std::max(longest, halved(clock, size / 2)); },
                         [&] { longest = std::max(longest, halved(clock, size / 2)); });
    return 1 + longest;
}

TEST(TaskSpan, OfNestedWorkIsTheLongestChain) {
    Worked clock;
    double longest = 0;
    const auto span = clock.measure([&] { longest = halved(clock, 64); });
    EXPECT_EQ(longest, 7);
    EXPECT_EQ(span.span, longest);
    EXPECT_EQ(span.work, 6 * 64 + 64);
}

/// What goes on beside a group's tasks counts beside them, and not behind.
TEST(TaskSpan, OfAGroupGoesOnBesideIt) {
    Worked clock;
    const auto span = clock.measure([&] {
        tbb::task_group group;
        group.run([&] { clock.work(4); });
        clock.work(3);
        group.run([&] { clock.work(2); });
        group.wait();
        clock.work(1);
    });
    EXPECT_EQ(span.work, 10);
    EXPECT_EQ(span.span, 6);
    EXPECT_EQ(span.tasks, 2u);
}

TEST(TaskSpan, DividesWorkAsForTheProcessorsAskedFor) {
    Worked clock;
    const int before = tbb::this_task_arena::max_concurrency();
    int meanwhile = 0;
    clock.measure([&] { meanwhile = tbb::this_task_arena::max_concurrency(); });
    EXPECT_EQ(meanwhile, 64);
    EXPECT_EQ(tbb::this_task_arena::max_concurrency(), before);
}

TEST(TaskSpan, LeavesTasksAloneThatAreNotMeasured) {
    std::atomic<int> done = 0;
    for_each(1000, [&](int) { ++done; });
    EXPECT_EQ(done, 1000);
}

}  // namespace
}  // namespace task_span_test
