// Protects what a page's pictures show: tone mapping, error colours, and PNGs that hold them.
#include "display_image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "crop_choice.h"
#include "synthetic_image.h"

namespace bench::test::display_image_test {
namespace {

std::vector<unsigned char> decode_base64(std::string_view text) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<unsigned char> bytes;
    unsigned bits = 0, count = 0;
    for (const char c : text) {
        if (c == '=') break;
        const auto digit = kDigits.find(c);
        if (digit == std::string_view::npos) throw std::invalid_argument("no base64");
        bits = bits << 6 | unsigned(digit);
        count += 6;
        if (count >= 8) bytes.push_back((unsigned char)(bits >> (count -= 8)));
    }
    return bytes;
}

TEST(DisplayImage, PngDataUriHoldsThePixels) {
    DisplayImage image{37, 5, {}};
    for (int i = 0; i < 37 * 5; ++i)
        image.pixels.push_back({std::uint8_t(i), std::uint8_t(7 * i), std::uint8_t(255 - i)});
    const std::string uri = png_data_uri(image);
    const std::string prefix = "data:image/png;base64,";
    ASSERT_EQ(uri.substr(0, prefix.size()), prefix);
    const auto bytes = decode_base64(std::string_view(uri).substr(prefix.size()));
    OIIO::Filesystem::IOMemReader source(bytes.data(), bytes.size());
    const auto input = OIIO::ImageInput::open("image.png", nullptr, &source);
    ASSERT_TRUE(input);
    EXPECT_EQ(input->spec().width, 37);
    EXPECT_EQ(input->spec().height, 5);
    std::vector<Rgb8> pixels(image.pixels.size());
    ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, pixels.data()));
    EXPECT_EQ(pixels, image.pixels);
}

TEST(DisplayImage, ToneMapIsExposureThenGamma) {
    const Image image = synthetic_image(4, 1, [](int x, int) { return x == 3 ? -1 : 0.25 * x; });
    const DisplayImage shown = tone_map(image, {2, 2.2}, {1, 0, 3, 1});
    EXPECT_EQ(shown.pixels[0][0], std::lround(255 * std::pow(0.5, 1 / 2.2)));
    EXPECT_EQ(shown.pixels[1][0], 255);
    EXPECT_EQ(shown.pixels[2][0], 0);
}

TEST(DisplayImage, AutomaticExposureLooksAtPixelsThatAreNotBlack) {
    const Image image = synthetic_image(100, 1, [](int x, int) { return x < 60 ? 0 : 0.5; });
    EXPECT_NEAR(automatic_exposure(image), 1.6, 1e-6);
    EXPECT_EQ(automatic_exposure(synthetic_image(3, 3, [](int, int) { return 0; })), 1);
}

TEST(DisplayImage, ErrorColoursAreWhiteAtZeroAndClampedAtTheEnds) {
    EXPECT_EQ(error_colour(0), (Rgb8{255, 255, 255}));
    EXPECT_EQ(error_colour(-5), kErrorColours.front());
    EXPECT_EQ(error_colour(5), kErrorColours.back());
    EXPECT_EQ(error_colour(std::numeric_limits<double>::quiet_NaN()), error_colour(0));
    EXPECT_GT(error_colour(0.5)[0], error_colour(0.5)[2]);    // too bright: red
    EXPECT_LT(error_colour(-0.5)[0], error_colour(-0.5)[2]);  // too dark: blue
}

TEST(DisplayImage, RelativeDifferenceIsSignedAndRelativeToTheReferences) {
    const Image truth = synthetic_image(4, 4, [](int, int) { return 2; });
    const Image image = synthetic_image(4, 4, [](int x, int) { return x < 2 ? 1 : 3; });
    const auto differences = relative_difference(image, truth, truth, {1, 0, 2, 1});
    ASSERT_EQ(differences.size(), 2u);
    EXPECT_NEAR(differences[0], -1 / 2.02, 1e-6);  // the floor is 1 % of the mean
    EXPECT_NEAR(differences[1], 1 / 2.02, 1e-6);
}

TEST(CropChoice, FindsWhereImagesDiffer) {
    const Image truth = synthetic_image(200, 100, [](int, int) { return 0.5; });
    const Image image = synthetic_image(
        200, 100, [](int x, int y) { return x >= 140 && x < 150 && y >= 60 && y < 70 ? 1 : 0.5; });
    const Image* images[] = {&truth, &image};
    const Crop crop = choose_crop(images, truth, {}, {40, 30});
    EXPECT_EQ(crop.width_px, 40);
    EXPECT_EQ(crop.height_px, 30);
    EXPECT_LE(crop.x, 140);
    EXPECT_GE(crop.x + crop.width_px, 150);
    EXPECT_LE(crop.y, 60);
    EXPECT_GE(crop.y + crop.height_px, 70);
}

TEST(CropChoice, StaysWithinSmallImages) {
    const Image truth = synthetic_image(20, 50, [](int, int) { return 0.5; });
    const Image* images[] = {&truth};
    const Crop crop = choose_crop(images, truth, {}, {192, 144});
    EXPECT_EQ(crop.width_px, 20);
    EXPECT_EQ(crop.height_px, 30);
}

}  // namespace
}  // namespace bench::test::display_image_test
