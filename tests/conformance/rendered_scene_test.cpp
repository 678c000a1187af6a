// Protects the command as a user runs it: two scenes with both integrators against LuxRender's
// images, a scene that must miss, and the exit codes.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "rendered_image.h"
#include "temporary_folder.h"

namespace rendered_scene_test {
namespace {

namespace fs = std::filesystem;

struct CommandEnd {
    int exit_code = -1;
    std::string said;
};

CommandEnd run(const std::string& arguments, const files::TemporaryFolder& folder) {
    const std::string log = folder / "log.txt";
    const int status =
        std::system((AIPS_CONFORMANCE " " + arguments + " > '" + log + "' 2>&1").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, folder.read("log.txt")};
}

TEST(ConformanceCommand, SimpleScenesLookAsLuxRenderRendersThem) {
    if (!fs::exists(CONFORMANCE_FOLDER)) GTEST_SKIP() << "no LuxRender images beside the project";
    const files::TemporaryFolder folder;
    const CommandEnd found =
        run("--scenes light-distant,shape-disk --first-passes 8 --seconds 30 --markdown '" +
                (folder / "table.md") + "'",
            folder);
    EXPECT_EQ(found.exit_code, 0) << found.said;
    EXPECT_NE(found.said.find("4 of 4 within the limits"), std::string::npos) << found.said;
    EXPECT_NE(folder.read("table.md").find("| shape-disk | aips |"), std::string::npos);
}

/// A light a tenth brighter than the reference's.
TEST(ConformanceCommand, ABrighterSceneIsAMiss) {
    if (!fs::exists(CONFORMANCE_FOLDER)) GTEST_SKIP() << "no LuxRender images beside the project";
    const files::TemporaryFolder folder;
    const fs::path from(CONFORMANCE_FOLDER);
    render::edited_scene(from / "light-point.lxs", folder,
                         {{"LightSource \"point\"", "LightSource \"point\" \"float gain\" [1.1]"}});
    fs::copy(from / "light-point.exr", folder.path() / "light-point.exr");
    const CommandEnd found =
        run("--folder '" + folder.path().string() + "' --integrators path --seconds 5", folder);
    EXPECT_EQ(found.exit_code, 1) << found.said;
    EXPECT_NE(found.said.find("MISS"), std::string::npos) << found.said;
}

TEST(ConformanceCommand, WhatCannotBeRenderedIsNoMissButAFailure) {
    const files::TemporaryFolder folder;
    folder.write("broken.lxs", "WorldBegin Shape \"no such shape\" WorldEnd");
    render::write_image({10, 10, std::vector<float>(300, 1.0f)}, folder.path() / "broken.exr");
    const CommandEnd found = run("--folder '" + folder.path().string() + "'", folder);
    EXPECT_EQ(found.exit_code, 3) << found.said;
    EXPECT_NE(found.said.find("no such shape"), std::string::npos) << found.said;
}

TEST(ConformanceCommand, ABadCommandIsRefused) {
    const files::TemporaryFolder folder;
    EXPECT_EQ(run("--folder /no/such/folder", folder).exit_code, 2);
    EXPECT_EQ(run("--scene x", folder).exit_code, 2);
}

}  // namespace
}  // namespace rendered_scene_test
