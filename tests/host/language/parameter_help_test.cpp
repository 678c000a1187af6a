// Help made from parameter declarations.
#include <gtest/gtest.h>

#include <array>

#include "lxs/sdk/parameters.h"

namespace lxs::parameter_help_test {
namespace {

constexpr std::array<std::string_view, 2> kModes = {"fast", "exact"};
constexpr std::array kParameters = {
    ParameterDeclaration{.name = "radius",
                         .type = ParameterType::Float,
                         .default_text = "1",
                         .doc = "Radius, scene units.",
                         .minimum = 0,
                         .older_name = "r"},
    ParameterDeclaration{.name = "mode",
                         .type = ParameterType::String,
                         .default_text = "fast",
                         .doc = "A | B.",
                         .choices = kModes},
    ParameterDeclaration{.name = "P",
                         .type = ParameterType::Point,
                         .doc = "corners",
                         .array = true,
                         .no_effect = true},
};

TEST(DescribeText, AlignsColumns) {
    EXPECT_EQ(describe_text(kParameters),
              "  radius  float       1     Radius, scene units. Older name: r. (at least 0)\n"
              "  mode    string      fast  A | B. (fast, exact)\n"
              "  P       point list        corners; has no effect\n");
}

TEST(DescribeMarkdown, IsATable) {
    EXPECT_EQ(describe_markdown(kParameters),
              "| name | type | default | allowed | meaning |\n"
              "| --- | --- | --- | --- | --- |\n"
              "| radius | float | 1 | at least 0 | Radius, scene units. Older name: r. |\n"
              "| mode | string | fast | fast, exact | A \\| B. |\n"
              "| P | point list | | | corners; has no effect |\n");
}

}  // namespace
}  // namespace lxs::parameter_help_test
