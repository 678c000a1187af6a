// Protects the start of lxsrender, which loads what reads images with the first image of a scene,
// and what is said where that part of an installation is missing or damaged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "lxsrender_process.h"

namespace lxs::test::image_module_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Renders with a copy of lxsrender in `folder`/bin, which finds modules beside that.
RunResult render_with_copy(const TemporaryFolder& folder, const std::string& world) {
    namespace fs = std::filesystem;
    const std::string copy = folder / "bin/lxsrender";
    fs::create_directories(folder / "bin");
    fs::copy_file(LXSRENDER, copy);
    folder.write("t.png", "no image");
    folder.write("scene.lxs", small_scene("", world));
    const auto become_the_copy = [&copy] {
        ::execl(copy.c_str(), "lxsrender", "scene.lxs", "--passes", "1", "--plugin-path", PLUGINS,
                nullptr);
        std::_Exit(127);
    };
    return LxsrenderProcess(folder, {}, "", become_the_copy).wait();
}

constexpr const char* kImage =
    "Texture \"t\" \"color\" \"imagemap\" \"string filename\" [\"t.png\"]\n";

TEST(ImageModule, IsNotLoadedAtTheStart) {
    const TemporaryFolder folder;
    const auto list_libraries = [] { ::setenv("LD_TRACE_LOADED_OBJECTS", "1", 1); };
    const RunResult result = LxsrenderProcess(folder, {}, "", list_libraries).wait();
    EXPECT_THAT(result.out, HasSubstr("libembree"));
    EXPECT_THAT(result.out, Not(HasSubstr("libOpenImageIO")));
}

TEST(ImageModule, NobodyMissesItWhereThereIsNoImage) {
    const TemporaryFolder folder;
    const RunResult result = render_with_copy(folder, "");
    EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST(ImageModule, ThatIsMissing) {
    const TemporaryFolder folder;
    const RunResult result = render_with_copy(folder, kImage);
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_THAT(result.err, HasSubstr("images can't be read: the file images.so is missing from "
                                      "the installation"));
}

TEST(ImageModule, ThatIsNoSharedLibrary) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "images");
    folder.write("images/images.so", "no shared library");
    const RunResult result = render_with_copy(folder, kImage);
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_THAT(result.err, HasSubstr("images can't be read: '"));
    EXPECT_THAT(result.err, HasSubstr("images.so' can't be loaded: "));
}

}  // namespace
}  // namespace lxs::test::image_module_test
