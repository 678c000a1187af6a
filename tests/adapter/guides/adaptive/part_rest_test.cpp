// Protects rest: what pays goes on, what does not costs nothing but a trial now and then.
#include "guides/adaptive/part_rest.h"

#include <gtest/gtest.h>

namespace aips::part_rest_test {
namespace {

constexpr std::uint64_t kStep = 10'000;

TEST(PartRest, WhatPaysStaysAwake) {
    PartRest rest;
    for (std::uint64_t paths = 0; paths < 100'000'000; paths += kStep) {
        rest.update(paths, true);
        ASSERT_TRUE(rest.awake()) << paths;
    }
}

TEST(PartRest, WhatDoesNotPayIsTriedWhenPathsHaveDoubled) {
    PartRest rest;
    std::uint64_t awake = 0, last = 0;
    for (std::uint64_t paths = 0; paths < 100'000'000; paths += kStep) {
        rest.update(paths, false);
        EXPECT_TRUE(rest.awake() || double(paths) >= kLearningPaths);
        if (!rest.awake()) continue;
        awake += kStep;
        last = paths;
    }
    EXPECT_LT(awake, 3'000'000u);
    EXPECT_GT(last, 50'000'000u);
}

TEST(PartRest, WhatCameToPayStaysAwakeAgain) {
    PartRest rest;
    for (std::uint64_t paths = 0; paths < 20'000'000; paths += kStep)
        rest.update(paths, paths > 3'000'000);
    EXPECT_TRUE(rest.awake());
}

}  // namespace
}  // namespace aips::part_rest_test
