// Protects spectral rendering end to end: a prism shows its spectrum in the right order, a scene
// that disperses next to nothing looks as it does in RGB, and the bits depend on the seed alone.
#include <gtest/gtest.h>

#include "block_test.h"
#include "rendered_image.h"

namespace {

constexpr const char* kPhotons =
    "--set aips.guide=none --set aips.photonperpass=100000 --set aips.startradius=1.5 ";

struct Colour {
    double r = 0, g = 0, b = 0;
};

/// Sum over the pixels [x0, x1) x [y0, y1), given in thousandths of the image's width.
Colour region(const render::Image& image, int x0, int x1, int y0, int y1) {
    const auto pixel = [&](int thousandths) {
        return static_cast<std::size_t>(thousandths) * image.width / 1000;
    };
    Colour sum;
    for (std::size_t y = pixel(y0); y < pixel(y1); ++y) {
        for (std::size_t x = pixel(x0); x < pixel(x1); ++x) {
            const float* rgb = &image.rgb[3 * (y * image.width + x)];
            sum.r += rgb[0];
            sum.g += rgb[1];
            sum.b += rgb[2];
        }
    }
    return sum;
}

// Short waves are bent most: in the spot on the wall blue lies left of green, green left of red.
TEST(Spectral, APrismShowsItsSpectrum) {
    const render::Folder folder;
    const auto scene = render::small_scene("prism", folder, 200, 150);
    const auto image = render::render(scene, kPhotons + std::string("--passes 24"), folder);
    const Colour left = region(image, 580, 600, 120, 136);
    const Colour middle = region(image, 608, 626, 120, 136);
    const Colour right = region(image, 630, 650, 120, 136);
    EXPECT_GT(left.b, 2 * left.r);
    EXPECT_GT(left.b, 1.5 * left.g);
    EXPECT_GT(middle.g, middle.b);
    EXPECT_GT(right.r, 2 * right.b);
    EXPECT_GT(right.r, 1.5 * right.g);
    EXPECT_GT(middle.g / middle.r, 1.2 * right.g / right.r);
}

// All else being equal: the same scene by wavelengths and in RGB. Interreflection of saturated
// colours differs, as products of spectra are not products of colours.
TEST(Spectral, WithHardlyAnyDispersionTheImageIsThatOfRgb) {
    const render::Folder folder;
    const auto plain = render::small_scene("glass-ball", folder, 96, 72);
    const auto rgb = render::render(plain, kPhotons + std::string("--passes 64"), folder);
    const auto dispersing = render::edited_scene(
        plain, folder,
        {{"\"string type\" [\"glass\"]", "\"string type\" [\"glass\"] \"float cauchyb\" [1e-7]"}});
    const auto spectral = render::render(dispersing, kPhotons + std::string("--passes 64"), folder);
    EXPECT_NE(rgb.rgb, spectral.rgb);
    const double difference =
        statistics::median_difference(spectral.block_means(12), rgb.block_means(12));
    EXPECT_LT(difference, 0.02);
    const Colour a = region(rgb, 0, 1000, 0, 750), b = region(spectral, 0, 1000, 0, 750);
    EXPECT_NEAR(b.r / a.r, 1, 0.03);
    EXPECT_NEAR(b.g / a.g, 1, 0.03);
    EXPECT_NEAR(b.b / a.b, 1, 0.03);
}

TEST(Spectral, SameBitsForAnyNumberOfThreads) {
    const render::Folder folder;
    const auto scene = render::small_scene("prism", folder, 64, 48);
    const std::string settings = "--set aips.photonperpass=20000 --passes 10 --threads ";
    EXPECT_EQ(render::render(scene, settings + "1", folder).rgb,
              render::render(scene, settings + "3", folder).rgb);
}

}  // namespace
