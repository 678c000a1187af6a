// Protects rest: what pays goes on, what does not costs nothing but a trial now and then.
#include "guides/adaptive/part_switch.h"

#include <gtest/gtest.h>

namespace aips::part_switch_test {
namespace {

constexpr std::uint64_t kStep = 10'000;

TEST(PartSwitch, WhatPaysStaysEnabled) {
    PartSwitch part;
    for (std::uint64_t paths = 0; paths < 100'000'000; paths += kStep) {
        part.update(paths, true);
        ASSERT_TRUE(part.enabled()) << paths;
    }
}

TEST(PartSwitch, WhatDoesNotPayIsTriedWhenPathsHaveDoubled) {
    PartSwitch part;
    std::uint64_t enabled = 0, last = 0;
    for (std::uint64_t paths = 0; paths < 100'000'000; paths += kStep) {
        part.update(paths, false);
        EXPECT_TRUE(part.enabled() || double(paths) >= kLearningPaths);
        if (!part.enabled()) continue;
        enabled += kStep;
        last = paths;
    }
    EXPECT_LT(enabled, 3'000'000u);
    EXPECT_GT(last, 50'000'000u);
}

TEST(PartSwitch, WhatCameToPayStaysEnabledAgain) {
    PartSwitch part;
    for (std::uint64_t paths = 0; paths < 20'000'000; paths += kStep)
        part.update(paths, paths > 3'000'000);
    EXPECT_TRUE(part.enabled());
}

}  // namespace
}  // namespace aips::part_switch_test
