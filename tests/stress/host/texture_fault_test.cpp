// Protects renders from textures that vanish: gone before they are read, removed or cut short while
// the render goes on. A message names file and place, the passes before are saved, the exit code is
// that of bad input; an image is never finished with colours that were not read.
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "lxs/imaging/exr_image.h"
#include "sabotaged_render.h"
#include "stress_case.h"

namespace lxs::test::texture_fault_test {
namespace {

using testing::HasSubstr;

// Tall enough for 256 rows of the texture cache's tiles: 48 lookups a pass leave most unread.
constexpr int kWidth = 64, kHeight = 16384;

void write_texture(const std::string& path) {
    const auto out = OIIO::ImageOutput::create(path);
    std::vector<unsigned char> pixels(std::size_t{3} * kWidth * kHeight);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = static_cast<unsigned char>((i * 2654435761u) >> 24);
    ASSERT_TRUE(out->open(path, OIIO::ImageSpec(kWidth, kHeight, 3, OIIO::TypeDesc::UINT8)));
    ASSERT_TRUE(out->write_image(OIIO::TypeDesc::UINT8, pixels.data()));
    ASSERT_TRUE(out->close());
}

/// A square that fills the picture, and shows one texture. Few lookups a pass: 8 x 6.
std::string textured_scene(const std::string& file) {
    return small_scene("", "Texture \"t\" \"color\" \"imagemap\" \"string filename\" [\"" + file +
                               "\"]\n"
                               "Material \"matte\" \"texture Kd\" [\"t\"]\n"
                               "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3]\n"
                               "  \"point P\" [-2 -2 -2  2 -2 -2  2 -2 2  -2 -2 2]\n"
                               "  \"float uv\" [0 0  1 0  1 1  0 1]");
}

class StressTexture : public testing::TestWithParam<const char*> {
  protected:
    StressTexture() {
        // What libpng jumps over in OpenImageIO's reader is no leak of ours.
        if (AIPS_SANITIZED) ::setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
        write_texture(render_.folder / file_);
        render_.folder.write("scene.lxs", textured_scene(file_));
    }
    const std::string file_ = std::string("t.") + GetParam();
    SabotagedRender render_;
};

INSTANTIATE_TEST_SUITE_P(Formats, StressTexture, testing::Values("png", "tif", "exr", "jpg"));

TEST_P(StressTexture, CutShortBeforeItIsRead) {
    std::filesystem::resize_file(render_.folder / file_, 3000);
    const RunResult result = render_.run("none", "", {"--passes", "2", "--strict"});
    if (result.exit_code == 0) GTEST_SKIP() << "this reader makes up what a file lacks";
    EXPECT_EQ(result.exit_code, 3) << result.err;
    EXPECT_THAT(result.err, HasSubstr("cannot read image"));
    EXPECT_FALSE(render_.folder.has("out.exr"));
}

TEST_P(StressTexture, CutShortBetweenPasses) {
    const RunResult result = render_.run("truncate", file_, {"--passes", "40"});
    EXPECT_EQ(result.exit_code, 3) << result.err;
    EXPECT_THAT(result.err, HasSubstr("scene.lxs:"));
    EXPECT_THAT(result.err, HasSubstr(file_ + "\" can't be read any more: "));
    EXPECT_THAT(result.err, HasSubstr("1 finished passes are in out.exr and out.png"));
    EXPECT_TRUE(render_.folder.has("out.exr"));
    stress::record(file_ + " cut short in pass 2 of 40", "exit code 3, pass 1 saved");
}

TEST_P(StressTexture, TakenAwayBetweenPasses) {
    ASSERT_EQ(render_.run("none", "", {"--passes", "40", "-o", "whole.exr"}).exit_code, 0);
    const RunResult result = render_.run("remove", file_, {"--passes", "40", "-o", "out.exr"});
    // What is held open is still there for the render; some readers open their file again.
    EXPECT_THAT(result.exit_code, testing::AnyOf(0, 3)) << result.err;
    EXPECT_TRUE(render_.folder.has("out.exr"));
    if (result.exit_code == 0) {
        // The headers tell the saboteur's settings apart.
        EXPECT_EQ(read_exr(render_.folder / "out.exr").channels,
                  read_exr(render_.folder / "whole.exr").channels);
    } else {
        EXPECT_THAT(result.err, HasSubstr("can't be read any more: "));
    }
    stress::record(file_ + " taken away in pass 2 of 40",
                   result.exit_code == 0 ? "the image is that of the whole file"
                                         : "exit code 3, pass 1 saved");
}

TEST_P(StressTexture, GoneBeforeTheFirstPass) {
    for (const std::string deed : {"remove", "truncate"}) {
        write_texture(render_.folder / file_);
        const RunResult result =
            render_.run(deed, file_, {"--passes", "40", "--set", "saboteur.pass=0"});
        EXPECT_EQ(result.exit_code, 3) << result.err;
        EXPECT_THAT(result.err, HasSubstr("can't be read any more: "));
        EXPECT_FALSE(render_.folder.has("out.exr")) << deed;
    }
}

}  // namespace
}  // namespace lxs::test::texture_fault_test
