// Protects which scenes are compared, how close they must be, and what the table calls a miss.
#include "scene_set.h"

#include <gtest/gtest.h>

#include "conformance_table.h"
#include "temporary_folder.h"

namespace conformance::scene_set_test {
namespace {

TEST(SceneSet, TakesScenesThatHaveAnImageByName) {
    const files::TemporaryFolder folder;
    for (const char* name : {"b.lxs", "b.exr", "a.lxs", "a.exr", "lonely.lxs", "image.exr"})
        folder.write(name, "");
    const auto all = scenes_in(folder.path(), {});
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].name, "a");
    EXPECT_EQ(all[1].reference.filename(), "b.exr");
    EXPECT_EQ(scenes_in(folder.path(), {"b"}).size(), 1u);
    EXPECT_THROW(scenes_in(folder.path(), {"lonely"}), std::runtime_error);
}

TEST(SceneSet, RoughGlassAloneMayDifferMore) {
    EXPECT_EQ(limit_for("material-roughglass").p95, 0.10);
    EXPECT_EQ(limit_for("material-glass").p95, 0.06);
    EXPECT_EQ(limit_for("material-glass").median, 0.02);
}

TEST(ConformanceTable, OneNegativeNumberIsAMiss) {
    Row row;
    row.limit = limit_for("any");
    EXPECT_TRUE(row.passes_limits());
    row.refused = 1;
    EXPECT_FALSE(row.passes_limits());
    EXPECT_NE(table_line(row, TableForm::Text).find("MISS"), std::string::npos);
    row.failure = "no image";
    EXPECT_NE(table_line(row, TableForm::Markdown).find("FAILED"), std::string::npos);
    EXPECT_NE(table_notes({row}).find("0 of 1 within"), std::string::npos);
}

TEST(ConformanceTable, EitherLimitAloneDecides) {
    Row row;
    row.limit = limit_for("any");
    row.found.luminance = {0.019, 0.059};
    EXPECT_TRUE(row.passes_limits());
    row.found.luminance = {0.021, 0.030};
    EXPECT_FALSE(row.passes_limits());
    row.found.luminance = {0.001, 0.061};
    EXPECT_FALSE(row.passes_limits());
}

}  // namespace
}  // namespace conformance::scene_set_test
