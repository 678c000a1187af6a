// Image textures: orientation, wrapping, gamma, channels, and files that can't be used.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lxs/spectrum/reflectance_colour.h"
#include "shading_fixture.h"
#include "temporary_folder.h"

namespace lxs::imagemap_test {
namespace {

class ImagemapTest : public ::testing::Test {
  protected:
    /// Writes floats as the format of the name's ending; returns the path.
    std::string write(const std::string& name, int width, int height, int channels,
                      const std::vector<float>& values) {
        std::string path = folder_ / name;
        OIIO::ImageSpec spec(
            width, height, channels,
            name.ends_with(".exr") ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        const auto out = OIIO::ImageOutput::create(path);
        EXPECT_TRUE(out && out->open(path, spec));
        EXPECT_TRUE(out->write_image(OIIO::TypeDesc::FLOAT, values.data()));
        out->close();
        return path;
    }
    /// 2 x 2: red, green above; blue, white below.
    std::string quadrants() {
        return write("quadrants.png", 2, 2, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1});
    }
    Rgb look(const ColorTexture& texture, float u, float v) {
        TexturePoint point;
        point.uv = {u, v};
        return texture.evaluate(point);
    }
    void expect_near(const Rgb& a, const Rgb& b) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(a[c], b[c], 1e-3f) << a << " against " << b;
    }

    files::TemporaryFolder folder_;
    ShadingFixture scene_;
};

// LuxRender's v runs downwards in the image; its exporters write vscale -1.
TEST_F(ImagemapTest, OriginIsTheUpperLeftCorner) {
    const auto map = scene_.make_color("imagemap", {text("filename", quadrants())});
    expect_near(look(*map, 0.25f, 0.25f), {1, 0, 0});
    expect_near(look(*map, 0.75f, 0.25f), {0, 1, 0});
    expect_near(look(*map, 0.25f, 0.75f), {0, 0, 1});
    const float half = std::pow(0.5f, 2.2f);  // between red and green, gamma undone
    expect_near(look(*map, 0.5f, 0.25f), {half, half, 0});
    EXPECT_TRUE(map->reads_image());
    EXPECT_FALSE(map->constant());
}

TEST_F(ImagemapTest, ScaleAndShiftPlaceTheImage) {
    const auto map = scene_.make_color(
        "imagemap", {text("filename", quadrants()), number("vscale", -1), number("vdelta", 1)});
    expect_near(look(*map, 0.25f, 0.75f), {1, 0, 0});
}

TEST_F(ImagemapTest, WrapsAsTold) {
    const auto wrapped = [&](const char* wrap) {
        const auto map =
            scene_.make_color("imagemap", {text("filename", quadrants()), text("wrap", wrap)});
        return look(*map, 1.25f, 0.25f);
    };
    expect_near(wrapped("repeat"), {1, 0, 0});
    expect_near(wrapped("black"), {0, 0, 0});
    expect_near(wrapped("white"), {1, 1, 1});
    expect_near(wrapped("clamp"), {0, 1, 0});
    EXPECT_THROW(wrapped("mirror"), InputError);
}

TEST_F(ImagemapTest, GammaIsUndoneAfterInterpolationAndBeforeGain) {
    const std::string path = write("step.exr", 2, 1, 3, {0, 0, 0, 0.5f, 0.5f, 0.5f});
    const auto map = scene_.make_color(
        "imagemap", {text("filename", path), number("gamma", 2), number("gain", 4)});
    expect_near(look(*map, 0.75f, 0.5f), Rgb(1.0f));
    expect_near(look(*map, 0.5f, 0.5f), Rgb(0.25f));
}

TEST_F(ImagemapTest, StoredAsSrgb) {
    const std::string path = write("srgb.png", 2, 1, 4, {0.5f, 0.02f, 1, 0.5f, 0.5f, 0, 1, 0.5f});
    const auto map = scene_.make_color(
        "imagemap", {text("filename", path), text("colorspace", "srgb"), number("gain", 2)});
    const float dark = 5 / 255.0f / 12.92f;
    expect_near(look(*map, 0.25f, 0.5f), Rgb(0.2159f, dark, 1) * 2);  // 128 of 255
    const auto alpha = scene_.make_float(
        "imagemap", {text("filename", path), text("colorspace", "srgb"), text("channel", "alpha")});
    EXPECT_NEAR(alpha->evaluate({}), 128 / 255.0f, 1e-3f);
    const auto dimmed = scene_.make_color(
        "imagemap", {text("filename", path), number("gamma", 1), flag("timesalpha", true)});
    expect_near(look(*dimmed, 0.25f, 0.5f), Rgb(0.5f, 5 / 255.0f, 1) * (128 / 255.0f));
    EXPECT_THROW(
        scene_.make_color("imagemap", {text("filename", path), text("colorspace", "rec2020")}),
        InputError);
}

// Between two texels lies the mean of what they are, not of how they are stored; alpha is linear.
TEST_F(ImagemapTest, SrgbTexelsAreLinearBeforeTheyAreInterpolated) {
    const std::string path = write("texels.png", 2, 1, 4, {0, 0, 0, 0.25f, 1, 1, 1, 0.75f});
    const std::vector<ParameterValue> map{text("filename", path),
                                          text("colorspace", "srgb_texels")};
    expect_near(look(*scene_.make_color("imagemap", map), 0.5f, 0.5f), Rgb(0.5f));
    expect_near(look(*scene_.make_color("imagemap", map), 0.75f, 0.5f), Rgb(1.0f));
    std::vector<ParameterValue> alpha = map;
    alpha.push_back(text("channel", "alpha"));
    TexturePoint middle;
    middle.uv = Vec2(0.5f, 0.5f);
    EXPECT_NEAR(scene_.make_float("imagemap", alpha)->evaluate(middle), 0.5f, 1e-2f);
    // Both readings of one file live side by side.
    const auto stored =
        scene_.make_color("imagemap", {text("filename", path), text("colorspace", "srgb")});
    expect_near(look(*stored, 0.5f, 0.5f), Rgb(0.2140f));
    const auto powers = scene_.make_color(
        "imagemap",
        {text("filename", path), text("colorspace", "gamma_texels"), number("gamma", 3)});
    expect_near(look(*powers, 0.5f, 0.5f), Rgb(0.5f));
}

TEST_F(ImagemapTest, PlainColorsAreSeenAsTheyAre) {
    const std::string path = write("red.exr", 1, 1, 3, {0.7f, 0.2f, 0.1f});
    for (const bool plain : {false, true}) {
        const auto map = scene_.make_color(
            "imagemap", {text("filename", path), number("gamma", 1), flag("plaincolors", plain)});
        const Rgb seen = colour_of_reflectance(look(*map, 0.5f, 0.5f));
        const float miss = (seen - Rgb(0.7f, 0.2f, 0.1f)).length();
        if (plain)
            EXPECT_LT(miss, 1e-4f);
        else
            EXPECT_GT(miss, 1e-3f);
    }
}

TEST_F(ImagemapTest, ChannelsOfFloatMaps) {
    const std::string path = write("one.png", 1, 1, 4, {0.2f, 0.4f, 0.6f, 0.8f});
    const auto channel = [&](const char* name) {
        const auto map = scene_.make_float(
            "imagemap", {text("filename", path), number("gamma", 1), text("channel", name)});
        return map->evaluate({});
    };
    EXPECT_NEAR(channel("mean"), 0.4f, 1e-3f);
    EXPECT_NEAR(channel("red"), 0.2f, 1e-3f);
    EXPECT_NEAR(channel("green"), 0.4f, 1e-3f);
    EXPECT_NEAR(channel("blue"), 0.6f, 1e-3f);
    EXPECT_NEAR(channel("alpha"), 0.8f, 1e-3f);
    EXPECT_NEAR(channel("colored_mean"), luminance({0.2f, 0.4f, 0.6f}), 1e-3f);
}

TEST_F(ImagemapTest, GreyImagesServeForColours) {
    const std::string path = write("grey.png", 1, 1, 1, {0.6f});
    const auto map = scene_.make_color("imagemap", {text("filename", path), number("gamma", 1)});
    expect_near(look(*map, 0.5f, 0.5f), Rgb(0.6f));
    const auto alpha =
        scene_.make_float("imagemap", {text("filename", path), text("channel", "alpha")});
    EXPECT_EQ(alpha->evaluate({}), 1);
}

TEST_F(ImagemapTest, BadValuesAreRefusedAndReportedOnce) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    const std::string path = write("bad.exr", 2, 1, 3, {nan, -1, 0.5f, inf, 1, 1});
    const auto map = scene_.make_color("imagemap", {text("filename", path), number("gamma", 1)});
    for (int i = -40; i < 40; ++i) {
        const Rgb value = look(*map, 0.05f * static_cast<float>(i), 0.3f);
        for (int c = 0; c < 3; ++c)
            ASSERT_TRUE(std::isfinite(value[c]) && value[c] >= 0);
    }
    ASSERT_EQ(scene_.diagnostics.warnings.size(), 1u);
    EXPECT_NE(scene_.diagnostics.warnings[0].find("3 values that are not finite or negative"),
              std::string::npos);
}

TEST_F(ImagemapTest, LookupsAtAnyCoordinateAreFinite) {
    const auto map = scene_.make_color("imagemap", {text("filename", quadrants())});
    const float inf = std::numeric_limits<float>::infinity();
    for (const float u : {0.0f, 1.0f, -0.0f, 1e9f, -1e30f, inf, std::nanf("")}) {
        const Rgb value = look(*map, u, 0.3f);
        EXPECT_TRUE(std::isfinite(value.x) && value.x >= 0) << u;
    }
}

TEST_F(ImagemapTest, DamagedAndMissingFilesAreErrorsThatNameThem) {
    const std::vector<float> pixels(std::size_t{64} * 64 * 3, 0.5f);
    write("whole.exr", 64, 64, 3, pixels);
    const std::string bytes = folder_.read("whole.exr");
    const std::string damaged = folder_.write("damaged.exr", bytes.substr(0, bytes.size() / 2));
    const std::string no_image = folder_.write("text.png", "not an image");
    for (const std::string& path : {damaged, no_image, folder_ / "missing.png"}) {
        try {
            scene_.make_color("imagemap", {text("filename", path)});
            ADD_FAILURE() << "no error for " << path;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("cannot read image \"" + path + "\""),
                      std::string::npos)
                << error.what();
        }
    }
    EXPECT_THROW(scene_.make_color("imagemap"), InputError);
}

}  // namespace
}  // namespace lxs::imagemap_test
