// Protects the film's sums: unbiased filtering, weights of passes, refusal of bad samples, and the
// same bits for any number of threads.
#include <OpenImageIO/imagebuf.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <random>

#include "film_samples.h"
#include "run_on_threads.h"

namespace lxs::test::film_accumulation_test {
namespace {

bool same_bits(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Rgb)) == 0;
}

TEST(FilmAccumulation, ConstantStaysConstantUnderEveryFilter) {
    for (const char* name :
         {"blackmanharris", "box", "catmullrom", "gaussian", "mitchell", "sinc", "triangle"}) {
        SceneContents contents = scene_of_size(13, 9);
        set_option(contents, "PixelFilter", name, {});
        const auto film = make(contents);
        const Rgb constant(0.25f, 3.0f, 1e4f);
        for (unsigned pass = 0; pass < 8; ++pass) {
            Samples samples = pixel_centres(*film, constant);
            std::mt19937 generator(pass);
            std::uniform_real_distribution<float> jitter(-0.5f, 0.49f);
            for (Vec2& p : samples.positions) {
                p += Vec2(jitter(generator), jitter(generator));
            }
            film->add_pass(samples.pass(1.0 + pass));
        }
        for (const Rgb& pixel : film->image()) {
            EXPECT_FLOAT_EQ(pixel.x, constant.x) << name;
            EXPECT_FLOAT_EQ(pixel.y, constant.y) << name;
            EXPECT_FLOAT_EQ(pixel.z, constant.z) << name;
        }
        EXPECT_EQ(film->refused_samples(), 0u);
    }
}

/// More samples and pixels than one job takes, in the order of the pixels and turned around: then
/// jobs have pixels in common, and sums round in another order.
TEST(FilmAccumulation, ManySamplesInAnyOrderAreInTheirPixels) {
    constexpr std::uint32_t kWidth = 260, kHeight = 150;
    const auto film = make(scene_of_size(kWidth, kHeight));
    const auto turned = make(scene_of_size(kWidth, kHeight));
    Samples samples;
    for (std::uint32_t i = 0; i < 2 * kWidth * kHeight; ++i) {
        const std::uint32_t pixel = i / 2;
        samples.positions.emplace_back(float(pixel % kWidth) + (i % 2 ? 0.75f : 0.0f),
                                       float(pixel / kWidth) + 0.5f);
        samples.radiance.emplace_back(float(pixel % 1000) * (i % 2 ? 0.25f : 0.75f));
    }
    samples.radiance[70'001] = Rgb(-1.0f);  // refused, wherever it comes
    film->add_pass(samples.pass());
    std::reverse(samples.positions.begin(), samples.positions.end());
    std::reverse(samples.radiance.begin(), samples.radiance.end());
    turned->add_pass(samples.pass());
    const std::vector<Rgb> image = film->image();
    EXPECT_TRUE(same_bits(image, turned->image()));
    for (std::size_t i = 0; i < image.size(); ++i)
        ASSERT_EQ(image[i].x, float(i % 1000) * (i == 35'000 ? 0.75f : 0.5f)) << i;
    EXPECT_EQ(film->refused_samples(), 1u);
    EXPECT_EQ(turned->refused_samples(), 1u);
}

TEST(FilmAccumulation, BoxOfOnePixelKeepsSamplesInTheirPixel) {
    const auto film = make(scene_of_size(4, 3));
    Samples samples{{Vec2(1.0f, 2.0f), Vec2(1.999f, 2.999f)}, {Rgb(2.0f), Rgb(4.0f)}};
    film->add_pass(samples.pass());
    const std::vector<Rgb> image = film->image();
    for (std::size_t i = 0; i < image.size(); ++i) {
        EXPECT_EQ(image[i].x, i == 2 * 4 + 1 ? 3.0f : 0.0f) << i;
    }
}

TEST(FilmAccumulation, GatherEqualsTheDefinition) {
    // The same sums written down naively: every pixel against every sample.
    SceneContents contents = scene_of_size(17, 11);
    set_option(contents, "PixelFilter", "triangle", {real("xwidth", 1.7), real("ywidth", 2.2)});
    const auto film = make(contents);
    const Samples samples = random_samples(*film, 400, 3, [](float u) { return Rgb(u); });
    film->add_pass(samples.pass());
    const std::vector<Rgb> image = film->image();
    for (int y = 0; y < 11; ++y) {
        for (int x = 0; x < 17; ++x) {
            double sum = 0, weight = 0;
            for (std::size_t i = 0; i < samples.positions.size(); ++i) {
                const double f = std::max(0.0, 1.7 - std::abs(samples.positions[i].x - (x + 0.5))) *
                                 std::max(0.0, 2.2 - std::abs(samples.positions[i].y - (y + 0.5)));
                sum += f * samples.radiance[i].x;
                weight += f;
            }
            EXPECT_NEAR(image[static_cast<std::size_t>(y * 17 + x)].x, sum / weight, 0.02);
        }
    }
}

TEST(FilmAccumulation, SameBitsForAnyNumberOfThreads) {
    SceneContents contents = scene_of_size(64, 48);
    contents.light_groups = {"default", "sun"};
    set_option(contents, "PixelFilter", "mitchell", {});
    std::vector<std::vector<Rgb>> images;
    for (const unsigned threads : {1u, 2u, 7u}) {
        concurrency::run_on(threads, [&] {
            const auto film = make(contents);
            for (unsigned pass = 0; pass < 5; ++pass) {
                const Samples samples = random_samples(
                    *film, 3072, pass, [](float u) { return Rgb(u, 1 / (u + 1e-3f), u * u); });
                film->add_pass(samples.pass(1 + 0.1 * pass, 2));
            }
            images.push_back(film->image());
        });
    }
    EXPECT_TRUE(same_bits(images[0], images[1]));
    EXPECT_TRUE(same_bits(images[0], images[2]));
}

TEST(FilmAccumulation, MeanOverPassesIsWeighted) {
    const auto film = make(scene_of_size(3, 2));
    film->add_pass(pixel_centres(*film, Rgb(1.0f)).pass(1000));
    film->add_pass(pixel_centres(*film, Rgb(5.0f)).pass(3000));
    for (const Rgb& pixel : film->image()) {
        EXPECT_EQ(pixel.x, 4.0f);
    }
    film->clear();
    for (const Rgb& pixel : film->image()) {
        EXPECT_EQ(pixel.x, 0.0f);
    }
    film->add_pass(pixel_centres(*film, Rgb(7.0f)).pass());
    EXPECT_EQ(film->image().front().x, 7.0f) << "cleared passes must not come back";
}

TEST(FilmAccumulation, ManyPassesDoNotDrift) {
    // 0.1f has no short binary fraction: in single precision 10^4 sums would be off by 1e-4.
    const auto film = make(scene_of_size(2, 2));
    const Samples samples = pixel_centres(*film, Rgb(0.1f));
    for (int pass = 0; pass < 10000; ++pass) {
        film->add_pass(samples.pass(1e6 + pass));
    }
    EXPECT_EQ(film->image().front().x, 0.1f);
}

TEST(FilmAccumulation, BadSamplesAreRefusedAndCounted) {
    const auto film = make(scene_of_size(2, 2));
    const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
    Samples samples = pixel_centres(*film, Rgb(2.0f));
    samples.positions.insert(samples.positions.end(), 5, Vec2(0.5f, 0.5f));
    samples.positions.back().x = nan;
    for (const Rgb& bad :
         {Rgb(nan, 1, 1), Rgb(1, infinity, 1), Rgb(1, 1, -1e-6f), Rgb(-infinity), Rgb(1.0f)}) {
        samples.radiance.push_back(bad);
    }
    film->add_pass(samples.pass());
    EXPECT_EQ(film->refused_samples(), 5u);
    for (const Rgb& pixel : film->image()) {
        EXPECT_EQ(pixel.x, 2.0f);
    }
}

/// Refusals say which light group or layer brought them.
TEST(FilmAccumulation, InvalidSamplesAreCountedByGroupAndLayer) {
    SceneContents contents = scene_of_size(2, 2);
    contents.light_groups = {"sun", "sky"};
    const auto film = make(contents);
    const float nan = std::nanf("");
    Samples samples{{Vec2(0.5f), Vec2(1.5f), Vec2(nan, 0)},
                    {Rgb(1.0f), Rgb(nan), Rgb(1.0f), Rgb(-1.0f), Rgb(1.0f), Rgb(1.0f)}};
    film->add_pass({samples.positions, samples.radiance, 2, 1});
    Samples layer = pixel_centres(*film, Rgb(nan));
    film->add_layer_pass("noise", {layer.positions, layer.radiance, 1, 1});
    film->set_layer("nodes", std::vector<float>{1, nan, -1, 2});
    std::map<std::string, std::uint64_t> counts;
    for (const InvalidSamples& invalid : film->invalid_samples())
        counts[invalid.origin] = invalid.count;
    const std::map<std::string, std::uint64_t> expected{{"light group \"sky\"", 2},
                                                        {"positions on the film", 1},
                                                        {"layer \"noise\"", 4},
                                                        {"layer \"nodes\"", 1}};
    EXPECT_EQ(counts, expected);
    EXPECT_EQ(film->refused_samples(), 8u);
}

TEST(FilmAccumulation, NegativeLobesGiveNoNegativePixels) {
    SceneContents contents = scene_of_size(9, 9);
    set_option(contents, "PixelFilter", "mitchell", {});
    const auto film = make(contents);
    Samples samples = pixel_centres(*film, Rgb(0.0f));
    samples.radiance[40] = Rgb(1e30f);
    film->add_pass(samples.pass());
    for (const Rgb& pixel : film->image()) {
        EXPECT_GE(pixel.x, 0.0f);
        EXPECT_TRUE(std::isfinite(pixel.x));
    }
}

TEST(FilmAccumulation, MalformedPassesAreTheCallersBug) {
    const auto film = make(scene_of_size(2, 2));
    const Samples samples = pixel_centres(*film, Rgb(1.0f));
    EXPECT_THROW(film->add_pass(samples.pass(1, 2)), std::invalid_argument);
    EXPECT_THROW(film->add_pass(samples.pass(0)), std::invalid_argument);
    EXPECT_THROW(film->add_pass(samples.pass(std::nan(""))), std::invalid_argument);
    EXPECT_THROW(film->set_layer("radius", std::vector<float>(3)), std::invalid_argument);
}

/// A colour layer that is given the image's samples is the image, bit for bit, and the image does
/// not notice its layers.
TEST(FilmAccumulation, ColourLayersGoThroughTheSameFilterAndMean) {
    const TemporaryFolder folder;
    const auto film = make(scene_of_size(9, 7)), alone = make(scene_of_size(9, 7));
    for (unsigned pass = 0; pass < 3; ++pass) {
        const Samples samples =
            random_samples(*film, 200, pass, [](float u) { return Rgb(u, 2 * u, u * u); });
        film->add_pass(samples.pass(1.0 + pass));
        film->add_layer_pass("copy", samples.pass(1.0 + pass));
        alone->add_pass(samples.pass(1.0 + pass));
    }
    EXPECT_TRUE(same_bits(film->image(), alone->image()));
    film->write_exr(folder / "out.exr", {});
    const OIIO::ImageBuf read(folder / "out.exr");
    ASSERT_EQ(read.nchannels(), 6);
    for (int i = 0; i < 63; ++i) {
        for (const char* channel : {"R", "G", "B"}) {
            EXPECT_EQ(read.getchannel(i % 9, i / 9, 0, read.spec().channelindex(channel)),
                      read.getchannel(i % 9, i / 9, 0,
                                      read.spec().channelindex(std::string("copy.") + channel)));
        }
    }
    EXPECT_GT(film->memory_bytes(), alone->memory_bytes());
    film->clear();
    film->write_exr(folder / "cleared.exr", {});
    const OIIO::ImageBuf cleared(folder / "cleared.exr");
    EXPECT_EQ(cleared.getchannel(4, 3, 0, cleared.spec().channelindex("copy.G")), 0);
}

TEST(FilmAccumulation, ALayerMayNotTakeALightGroupsName) {
    SceneContents contents = scene_of_size(2, 2);
    contents.light_groups = {"default", "photons"};
    const auto film = make(contents);
    const Samples samples = pixel_centres(*film, Rgb(1.0f));
    EXPECT_THROW(film->add_layer_pass("photons", samples.pass()), std::runtime_error);
    EXPECT_THROW(film->add_layer_pass("", samples.pass()), std::invalid_argument);
    EXPECT_THROW(film->add_layer_pass("other", samples.pass(1, 2)), std::invalid_argument);
}

TEST(FilmAccumulation, MemoryDoesNotGrowWithPasses) {
    const auto film = make(scene_of_size(32, 32));
    const std::size_t before = film->memory_bytes();
    for (int pass = 0; pass < 50; ++pass) {
        film->add_pass(pixel_centres(*film, Rgb(1.0f)).pass());
    }
    EXPECT_EQ(film->memory_bytes(), before);
}

// A spectral render: each pass holds the values that a grey, and a green, have at its wavelengths.
// The grey stays grey whatever the wavelengths, even of a single pass; the green is right in the
// mean.
TEST(FilmAccumulation, WavelengthsOfPassesBecomeColours) {
    const auto film = make(scene_of_size(3, 2));
    const Rgb green(0.1f, 0.6f, 0.2f);
    for (const std::uint64_t passes : {1u, 400u}) {
        for (const Rgb& colour : {Rgb(0.5f), green}) {
            film->clear();
            for (std::uint64_t pass = 0; pass < passes; ++pass) {
                const Wavelengths wavelengths = wavelengths_of_pass(5, pass);
                film->set_wavelengths(wavelengths);
                const double weight = 1 + double(pass % 3);
                const Samples samples = pixel_centres(*film, wavelengths.values_of(colour));
                film->add_pass(samples.pass(weight));
                film->add_layer_pass("layer", samples.pass(weight));
            }
            if (passes == 1 && colour == green) continue;
            for (const Rgb& pixel : film->image()) {
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(pixel[c], colour[c], passes == 1 ? 1e-6 : 0.005) << passes;
            }
        }
    }
}

}  // namespace
}  // namespace lxs::test::film_accumulation_test
