// Protects the rule that references have at most a quarter of every radius compared.
#include "radius_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bench::test::radius_check_test {
namespace {

Json summary(double reference, double first, double second) {
    const auto run = [](double radius) {
        return Json{{"status", "done"},
                    {"settings", {{"scene", "s"}}},
                    {"integrator_statistics", {{"radius", radius}}}};
    };
    const Json images{{"1", {{"radius", nullptr}}}, {"2", {{"radius", reference}}}};
    return {{"scenes", Json::array({{{"name", "s"}, {"reference", {{"images", images}}}}})},
            {"runs", Json::array({run(first), run(second)})}};
}

TEST(RadiusCheck, WarnsWhenARunShrinksBelowFourTimesTheReferences) {
    EXPECT_TRUE(radius_warnings(summary(0.25, 1, 2)).empty());
    const auto warnings = radius_warnings(summary(0.25, 2, 0.9));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_THAT(warnings[0], testing::HasSubstr("s: the references' radius 0.25"));
}

TEST(RadiusCheck, RunsWithoutRadiusAndScenesWithoutReferencesDoNotCount) {
    EXPECT_TRUE(radius_warnings(summary(0.25, 0, 1)).empty());
    Json without = summary(0.25, 0.1, 0.1);
    without["scenes"][0]["reference"] = nullptr;
    EXPECT_TRUE(radius_warnings(without).empty());
}

}  // namespace
}  // namespace bench::test::radius_check_test
