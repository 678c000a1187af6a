// Scenes written for LuxRender by others are read without error.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "scene_fakes.h"

namespace lxs::test::real_scenes_test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scenes_below(const fs::path& folder) {
    std::vector<fs::path> scenes;
    if (!fs::exists(folder)) return scenes;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ".lxs") scenes.push_back(entry.path());
    }
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

void read_all(const fs::path& folder) {
    const std::vector<fs::path> scenes = scenes_below(folder);
    if (scenes.empty()) GTEST_SKIP() << "no scenes in " << folder;
    for (const fs::path& scene : scenes) {
        CollectingDiagnostics diagnostics;
        SCOPED_TRACE(scene.string());
        try {
            const SceneContents contents =
                read_scene(scene.string(), accepting_registry(), diagnostics);
            EXPECT_FALSE(contents.primitives.empty() && contents.instances.empty());
            EXPECT_TRUE(contents.options.count("Camera") == 1);
            EXPECT_TRUE(contents.options.count("Film") == 1);
            EXPECT_GT(contents.end.line, 1u);
        } catch (const std::exception& error) {
            ADD_FAILURE() << error.what();
        }
    }
}

TEST(RealScenes, Conformance) {
    read_all(fs::path(AIPS_SHARED_DIR) / "lux-conformance");
}

TEST(RealScenes, LuxRenderScenes) {
    read_all(fs::path(AIPS_SHARED_DIR) / "lux-scenes");
}

TEST(RealScenes, CornellBoxHasItsParts) {
    const fs::path scene = fs::path(AIPS_SHARED_DIR) / "lux-scenes/cornell_box/sppm.lxs";
    if (!fs::exists(scene)) GTEST_SKIP() << "no " << scene;
    CollectingDiagnostics diagnostics;
    const SceneContents contents = read_scene(scene.string(), accepting_registry(), diagnostics);
    EXPECT_EQ(contents.primitives.size(), 8u);  // five walls, cube, ball, lamp
    ASSERT_TRUE(contents.primitives.back().emission);
    EXPECT_EQ(contents.material_names.at(contents.primitives.back().material_index), "Lamp");
    EXPECT_EQ(contents.options.at("SurfaceIntegrator").parameters.values.size(), 15u);
}

}  // namespace
}  // namespace lxs::test::real_scenes_test
