// Protects when snapshots are due, and that the record of passes stays small and whole.
#include <gtest/gtest.h>

#include <vector>

#include "pass_trace.h"
#include "time_marks.h"

namespace bench::test::measured_pass_test {
namespace {

TEST(TimeMarks, AreDueOnceOnTheirOwnClock) {
    TimeMarks marks(std::vector<double>{4, 8}, "both");
    EXPECT_TRUE(marks.due(1.9, 1).empty());
    auto due = marks.due(2, 1);  // half the smallest budget
    ASSERT_EQ(due.size(), 1u);
    EXPECT_EQ(due[0].clock, "cpu");
    EXPECT_EQ(due[0].seconds, 2);
    EXPECT_TRUE(marks.due(3.9, 1.9).empty());
    due = marks.due(9, 4.5);  // one long pass: cpu 4 and 8, wall 2 and 4
    EXPECT_EQ(due.size(), 4u);
    EXPECT_FALSE(marks.all_passed());
    EXPECT_EQ(marks.due(16, 8).size(), 1u);
    EXPECT_TRUE(marks.all_passed());
}

TEST(TimeMarks, OneClockAlone) {
    TimeMarks marks(std::vector<double>{1}, "cpu");
    EXPECT_EQ(marks.due(1, 0).size(), 2u);
    EXPECT_TRUE(marks.all_passed());
}

TEST(TimeMarks, WithoutBudgetsAllHavePassed) {
    EXPECT_TRUE(TimeMarks({}, "both").all_passed());
}

TEST(PassMarks, AreDueOnceEach) {
    PassMarks marks(std::vector<std::uint64_t>{1, 3});
    EXPECT_FALSE(marks.all_passed());
    EXPECT_TRUE(marks.due(1));
    EXPECT_FALSE(marks.due(2));
    EXPECT_FALSE(marks.all_passed());
    EXPECT_TRUE(marks.due(3));
    EXPECT_FALSE(marks.due(4));
    EXPECT_TRUE(marks.all_passed());
}

TEST(PassTrace, StaysSmallAndKeepsFirstAndLast) {
    PassTrace trace;
    for (std::uint64_t pass = 1; pass <= 10'000; ++pass) {
        PassTotals totals;
        totals.passes = pass;
        trace.add(totals);
        ASSERT_LE(trace.entries().size(), PassTrace::kMostEntries);
        ASSERT_EQ(trace.entries().back().passes, pass);
    }
    const auto entries = trace.entries();
    EXPECT_EQ(entries.front().passes, 1u);
    EXPECT_GT(entries.size(), PassTrace::kMostEntries / 4);
    for (std::size_t i = 1; i < entries.size(); ++i)
        EXPECT_LT(entries[i - 1].passes, entries[i].passes);
}

}  // namespace
}  // namespace bench::test::measured_pass_test
