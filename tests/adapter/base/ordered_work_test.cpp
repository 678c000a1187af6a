// Protects work on all threads whose result must not depend on their number: sums by key in the
// order of the items, sums by ranges, vectors filled.
#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "aips/core/sampling/low_discrepancy.h"
#include "base/assign_all.h"
#include "base/disjoint_ranges.h"
#include "base/ordered_sum.h"
#include "run_on_threads.h"

namespace aips::ordered_work_test {
namespace {

constexpr std::size_t kItems = 40 * kItemsPerJob + 17;
using KeyOf = std::function<std::uint32_t(std::size_t)>;

struct Ranges {
    std::vector<std::pair<std::size_t, std::size_t>> all;  // by where they begin
};

Ranges ranges_of(const KeyOf& key_of, std::size_t items = kItems) {
    return concurrency::run_on(7, [&] {
        std::vector<std::size_t> end(items + 1, 0);
        in_disjoint_ranges(items, key_of,
                           [&](std::size_t first, std::size_t last) { end[first] = last; });
        Ranges ranges;
        for (std::size_t first = 0; first < items; first = end[first])
            ranges.all.emplace_back(first, end[first]);
        return ranges;
    });
}

void expect_no_common_keys(const Ranges& ranges, const KeyOf& key_of) {
    std::set<std::uint32_t> before;
    for (const auto& [first, last] : ranges.all) {
        ASSERT_LT(first, last);
        std::set<std::uint32_t> keys;
        for (std::size_t i = first; i < last; ++i)
            keys.insert(key_of(i));
        for (const std::uint32_t key : keys)
            EXPECT_TRUE(before.insert(key).second) << key;
    }
}

TEST(DisjointRanges, AreManyWhereKeysRise) {
    const KeyOf rising = [](std::size_t i) { return std::uint32_t(i / 3); };
    const KeyOf bands = [](std::size_t i) { return std::uint32_t(i / 3000); };
    for (const KeyOf& key_of : {rising, bands}) {
        const Ranges ranges = ranges_of(key_of);
        EXPECT_GT(ranges.all.size(), 15u);
        expect_no_common_keys(ranges, key_of);
    }
}

TEST(DisjointRanges, HaveNoKeyInCommonHoweverKeysCome) {
    const KeyOf falling = [](std::size_t i) { return std::uint32_t(kItems - i); };
    const KeyOf again = [](std::size_t i) { return std::uint32_t(i % (kItems / 2)); };
    const KeyOf any = [](std::size_t i) { return hash_bits(std::uint32_t(i)); };
    // Rising but for one late item that goes with the first ones.
    const KeyOf stray = [](std::size_t i) { return i == kItems - 5 ? 7u : std::uint32_t(i); };
    const KeyOf same = [](std::size_t /*i*/) { return 0u; };
    for (const KeyOf& key_of : {falling, again, any, stray, same})
        expect_no_common_keys(ranges_of(key_of), key_of);
}

TEST(DisjointRanges, OfFewItemsAreOne) {
    const KeyOf rising = [](std::size_t i) { return std::uint32_t(i); };
    for (const std::size_t items : {1, 2, 100})
        EXPECT_EQ(ranges_of(rising, items).all.size(), 1u);
}

TEST(OrderedSum, RoundsAlikeForAnyNumberOfThreads) {
    std::vector<double> values(kItems);
    for (std::size_t i = 0; i < kItems; ++i)
        values[i] = 1.0 / double(1 + hash_bits(std::uint32_t(i)) % 1000);
    const auto sum = [&] {
        return ordered_sum<double>(kItems, [&](std::size_t first, std::size_t last) {
            return std::accumulate(values.begin() + std::ptrdiff_t(first),
                                   values.begin() + std::ptrdiff_t(last), 0.0);
        });
    };
    const double one = concurrency::run_on(1, sum);
    EXPECT_NEAR(one, std::accumulate(values.begin(), values.end(), 0.0), 1e-9 * one);
    for (const unsigned threads : {2u, 7u})
        EXPECT_EQ(one, concurrency::run_on(threads, sum));
    EXPECT_EQ(ordered_sum<double>(0, [](std::size_t, std::size_t) { return 1.0; }), 0);
}

TEST(AssignAll, LeavesWhatAssignLeavesAndTakesNoMoreMemory) {
    std::vector<int> values;
    for (const std::size_t count : {kItems, std::size_t{3}, kItems + 1, std::size_t{0}}) {
        std::vector<int> expected(values);
        expected.assign(count, int(count));
        assign_all(values, count, int(count));
        EXPECT_EQ(values, expected);
        EXPECT_LE(values.capacity(), kItems + 1);
    }
}

}  // namespace
}  // namespace aips::ordered_work_test
