// Protects the outputs where the machine fails: full disk, size limit, read-only folder, folder
// deleted during the render. The message is clear, the exit code documented, no file is torn, and
// what was rendered is saved wherever a place takes it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include "sabotaged_render.h"
#include "stress_case.h"

namespace lxs::test::output_fault_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A scene whose film is written after each pass.
std::string eager_scene() {
    return small_scene(
        "Film \"fleximage\" \"integer xresolution\" [128] \"integer yresolution\" [96]\n"
        "  \"string filename\" [\"out\"] \"integer writeinterval\" [1]");
}

void limit_file_size(rlim_t bytes) {
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
}

std::size_t temporary_files(const fs::path& folder) {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder))
        count += entry.path().extension() == ".tmp" ? 1 : 0;
    return count;
}

TEST(StressOutput, FullDeviceSavesBeside) {
    SabotagedRender render;
    render.folder.write("scene.lxs", small_scene());
    fs::create_symlink("/dev/full", render.folder / "full.exr");
    const RunResult result = render.run("none", "", {"--passes", "2", "-o", "full.exr"});
    EXPECT_EQ(result.exit_code, 5) << result.err;
    EXPECT_THAT(result.err, HasSubstr("error: cannot write 'full.exr': No space left on device"));
    EXPECT_THAT(result.err, HasSubstr("full.rescued.exr' instead"));
    EXPECT_TRUE(render.folder.has("full.rescued.exr"));
    EXPECT_TRUE(render.folder.has("full.png"));  // the other output is not lost with it
    stress::record("output to a full device", "saved beside, exit code 5");
}

TEST(StressOutput, ANameWithoutRoomForMoreIsSavedBesideToo) {
    SabotagedRender render;
    render.folder.write("scene.lxs", small_scene());
    const std::string stem(251, 'x');
    fs::create_symlink("/dev/full", render.folder / (stem + ".exr"));
    const RunResult result = render.run("none", "", {"--passes", "2", "-o", stem + ".exr"});
    EXPECT_EQ(result.exit_code, 5) << result.err;
    EXPECT_TRUE(render.folder.has(stem.substr(0, 243) + ".rescued.exr")) << result.err;
    EXPECT_TRUE(render.folder.has(stem + ".png"));
}

TEST(StressOutput, FileSizeLimitsLeaveWholeFilesOnly) {
    SabotagedRender render;
    render.folder.write("scene.lxs", eager_scene());
    ASSERT_EQ(render.run("none", "", {"--passes", "1", "-o", "old.exr"}).exit_code, 0);
    // Of the image that is refused below, which another number of passes compresses otherwise.
    ASSERT_EQ(render.run("none", "", {"--passes", "2", "-o", "new.exr"}).exit_code, 0);
    const std::size_t whole = render.folder.read("new.exr").size();
    for (const rlim_t limit : {rlim_t{0}, rlim_t{1}, rlim_t{1000}, rlim_t{whole - 1}}) {
        const std::string old = render.folder.read("old.exr");
        const RunResult result = render.run("none", "", {"--passes", "2", "-o", "old.exr"},
                                            [&] { limit_file_size(limit); });
        EXPECT_EQ(result.exit_code, 5) << limit << result.err;
        EXPECT_EQ(render.folder.read("old.exr"), old) << "torn at " << limit;
        if (limit >= 1000) {  // standard error is a file too
            EXPECT_THAT(result.err, HasSubstr("cannot write 'old.exr': File too large"));
        }
        EXPECT_EQ(temporary_files(render.folder.path()), 0u);
    }
    EXPECT_EQ(render
                  .run("none", "", {"--passes", "2", "-o", "old.exr"},
                       [&] { limit_file_size(100 * whole); })
                  .exit_code,
              0);
    stress::record("file size limits of 0, 1, 1000 and size - 1 bytes",
                   "exit code 5, the older file whole, no other left");
}

TEST(StressOutput, FolderDeletedDuringTheRender) {
    SabotagedRender render;
    render.folder.write("scene.lxs", small_scene());
    fs::create_directories(render.folder / "deep/er");
    const RunResult result = render.run(
        "remove", "deep", {"--passes", "3", "-o", "deep/er/a.exr", "--stats", "deep/er/a.json"});
    EXPECT_EQ(result.exit_code, 5) << result.err;
    EXPECT_THAT(result.err, HasSubstr("cannot write 'deep/er/a.exr': No such file or directory"));
    for (const char* file : {"a.rescued.exr", "a.rescued.png", "a.rescued.json"})
        EXPECT_TRUE(render.folder.has(file)) << file;
    EXPECT_FALSE(render.folder.has("deep"));
    stress::record("output folder deleted in pass 2 of 3", "image of 3 passes saved beside it");
}

TEST(StressOutput, RescueOverwritesNothing) {
    SabotagedRender render;
    render.folder.write("scene.lxs", small_scene());
    render.folder.write("a.rescued.exr", "precious");
    fs::create_directories(render.folder / "deep");
    const RunResult result = render.run("remove", "deep", {"--passes", "2", "-o", "deep/a.exr"});
    EXPECT_EQ(result.exit_code, 5) << result.err;
    EXPECT_EQ(render.folder.read("a.rescued.exr"), "precious");
    EXPECT_TRUE(render.folder.has("a.rescued-2.exr"));
}

TEST(StressOutput, SnapshotThatFailsDoesNotEndTheRender) {
    SabotagedRender render;
    render.folder.write("scene.lxs", eager_scene());
    fs::create_directories(render.folder / "deep");
    // The folder is gone from the first pass on; passes go on until the time is up.
    const RunResult result = render.run(
        "remove", "deep", {"--time", "2.5", "-o", "deep/a.exr", "--set", "saboteur.pass=0"});
    EXPECT_EQ(result.exit_code, 5) << result.err;
    EXPECT_THAT(result.err, HasSubstr("warning: cannot write 'deep/a.exr': No such file or "
                                      "directory; rendering goes on, and writing is tried again "
                                      "later"));
    EXPECT_TRUE(render.folder.has("a.rescued.exr"));
}

/// Root may write anywhere: only a process without that right finds folders read-only.
void respect_permissions() {
    ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0);
}

TEST(StressOutput, FolderThatIsOrBecomesReadOnly) {
    SabotagedRender render;
    render.folder.write("scene.lxs", small_scene());
    const std::string locked = render.folder / "locked";
    fs::create_directories(locked);
    const std::vector<std::string> options{"--passes", "2", "-o", "locked/a.exr"};
    const RunResult later = render.run("make read-only", "locked", options, &respect_permissions);
    EXPECT_EQ(later.exit_code, 5) << later.err;
    EXPECT_THAT(later.err, HasSubstr("cannot write 'locked/a.exr': Permission denied"));
    EXPECT_THAT(later.err, HasSubstr("a.rescued.exr' instead"));
    EXPECT_TRUE(render.folder.has("a.rescued.exr"));
    const RunResult at_once = render.run("none", "", options, &respect_permissions);
    EXPECT_EQ(at_once.exit_code, 5);
    EXPECT_THAT(at_once.err, HasSubstr("cannot write 'locked/a.exr': Permission denied"));
    EXPECT_THAT(at_once.err, testing::Not(HasSubstr("rendering")));
    fs::permissions(locked, fs::perms::owner_all);
}

TEST(StressOutput, FolderInPlaceOfTheImage) {
    SabotagedRender render;
    render.folder.write("scene.lxs", small_scene());
    render.folder.write("a.exr", "");
    const RunResult result =
        render.run("put a folder in its place", "a.exr", {"--passes", "2", "-o", "a.exr"});
    EXPECT_EQ(result.exit_code, 5) << result.err;
    EXPECT_THAT(result.err, HasSubstr("cannot write 'a.exr': Is a directory"));
    EXPECT_TRUE(render.folder.has("a.rescued.exr"));
}

TEST(StressOutput, StandardOutputThatIsFull) {
    TemporaryFolder folder;
    const RunResult result =
        LxsrenderProcess(folder, {"--list-plugins"}, "", [] { limit_file_size(10); }).wait();
    EXPECT_EQ(result.exit_code, 5);
}

}  // namespace
}  // namespace lxs::test::output_fault_test
