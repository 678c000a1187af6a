// Protects merged images: means weighted by samples, errors that fall as those of independent
// renders, and the refusal of whatever would make a merged image wrong.
#include "lxs/merge/merger.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "lxs/imaging/image_header.h"
#include "rendered_image.h"

namespace lxs::merger_test {
namespace {

using test::rendered;
using testing::HasSubstr;
namespace header = image_header;

ExrImage merged(std::initializer_list<ExrImage> images) {
    Merger merger;
    int number = 0;
    for (const ExrImage& image : images)
        merger.add(image, std::to_string(++number) + ".exr");
    return merger.merged();
}

TEST(Merger, WeighsByWhatImagesHold) {
    const ExrImage image = merged({rendered(1, 10, 1.0f, 0.4f), rendered(2, 30, 3.0f, 0.2f)});
    EXPECT_FLOAT_EQ(image.channels.at("R")[5], 2.5f);
    // (10 * 0.4)^2 + (30 * 0.2)^2 = 52
    EXPECT_FLOAT_EQ(image.channels.at("error.G")[0], std::sqrt(52.0f) / 40);
    EXPECT_EQ(image.metadata.at(header::kSeed), "1 2");
    EXPECT_EQ(image.metadata.at(header::kPasses), "40");
    EXPECT_EQ(image.metadata.at(header::kSamples), "40");
    EXPECT_EQ(image.metadata.at(header::kScene), "room.lxs");
    EXPECT_EQ(image.frame.x_resolution, 5u);
}

/// Merging lessens noise alone: what radii blur stays as it is in the mean of the renders.
TEST(Merger, BiasIsTheMeanOfBiases) {
    ExrImage a = rendered(1, 10, 1.0f, 0.4f), b = rendered(2, 30, 1.0f, 0.2f);
    for (ExrImage* image : {&a, &b}) {
        const float bias = image == &a ? -0.3f : 0.1f;
        for (const char* channel : {"bias.R", "bias.G", "bias.B"})
            image->channels[channel].assign(6, bias);
        image->metadata[header::kRelMseOfBias] = image == &a ? "0.08" : "0.04";
        image->metadata[header::kRmseOfBias] = image == &a ? "0.3" : "0";
    }
    Merger merger;
    merger.add(a, "1.exr");
    merger.add(b, "2.exr");
    EXPECT_NEAR(merger.merged().channels.at("bias.G")[0], 0.0f, 1e-7f);
    const ErrorEstimate error = *merger.error();
    EXPECT_NEAR(error.relmse_of_bias, 0.05, 1e-6);
    EXPECT_NEAR(error.rmse_of_bias, std::sqrt(0.25 * 0.09), 1e-6);
    EXPECT_GT(error.relmse, error.relmse_of_bias);
}

TEST(Merger, OrderAndGroupsDoNotMatter) {
    const ExrImage a = rendered(1, 10, 1.0f, 0.4f), b = rendered(2, 30, 3.0f, 0.2f),
                   c = rendered(3, 5, 0.5f, 0.9f);
    const ExrImage together = merged({a, b, c}), stepwise = merged({c, merged({b, a})});
    EXPECT_EQ(stepwise.metadata.at(header::kSeed), "1 2 3");
    for (const auto& [channel, values] : together.channels)
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_NEAR(values[i], stepwise.channels.at(channel)[i], 1e-6f) << channel;
}

/// What is told of the error is that of the mean: estimated in each image, and known in the test.
TEST(Merger, ErrorIsThatOfTheMean) {
    std::mt19937 random(5);
    std::normal_distribution<float> normal;
    Merger merger;
    const std::array<int, 3> samples{16, 16, 64};
    ExrImage one;
    for (int k = 0; k < 3; ++k) {
        const float error = 0.4f / std::sqrt(float(samples[std::size_t(k)]));
        one = rendered(std::uint64_t(k), samples[std::size_t(k)], 0, error);
        one.frame = {100, 100, 0, 0, 100, 100};
        for (auto& [channel, values] : one.channels) {
            values.assign(10000, error);
            if (channel.starts_with("error.")) continue;
            for (float& value : values)
                value = 2 + error * normal(random);
        }
        merger.add(one, "x.exr");
    }
    double squares = 0;
    for (const float value : merger.merged().channels.at("G"))
        squares += (double{value} - 2) * (double{value} - 2) / 10000;
    // Significance 1e-4: 4 standard errors of a mean of 10000 squares.
    const double expected = 0.16 / 96;
    EXPECT_NEAR(squares, expected, 4 * std::sqrt(2.0 / 10000) * expected);
    EXPECT_NEAR(merger.error()->rmse, std::sqrt(expected), 0.01 * std::sqrt(expected));
    EXPECT_EQ(merger.error()->passes, 96u);
}

TEST(Merger, KnowsNoErrorWhereAnImageTellsNone) {
    Merger merger;
    ExrImage image = rendered(1, 10, 1, 0);
    std::erase_if(image.channels, [](const auto& c) { return c.first.starts_with("error."); });
    merger.add(image, "a.exr");
    EXPECT_FALSE(merger.error());
}

TEST(Merger, KeepsTheLeastDepth) {
    ExrImage a = rendered(1, 10, 1, 0.1f), b = rendered(2, 10, 1, 0.1f);
    a.channels["depth.Z"] = {1e10f, 2, 3, 4, 5, 6};
    b.channels["depth.Z"] = {7, 1e10f, 2.5f, 8, 9, 1e10f};
    EXPECT_EQ(merged({a, b}).channels.at("depth.Z"), (std::vector<float>{7, 2, 2.5f, 4, 5, 6}));
}

/// One pixel's ids and coverages in the ranks of two layers.
void set_matte(ExrImage& image, std::array<std::pair<std::uint32_t, float>, 4> ranks) {
    image.metadata["cryptomatte/1234567/name"] = "objects";
    const char* const channels[4][2] = {{"objects00.R", "objects00.G"},
                                        {"objects00.B", "objects00.A"},
                                        {"objects01.R", "objects01.G"},
                                        {"objects01.B", "objects01.A"}};
    for (std::size_t rank = 0; rank < ranks.size(); ++rank) {
        image.channels[channels[rank][0]].assign(6, std::bit_cast<float>(ranks[rank].first));
        image.channels[channels[rank][1]].assign(6, ranks[rank].second);
    }
}

TEST(Merger, JoinsCryptomattesById) {
    ExrImage a = rendered(1, 10, 1, 0.1f), b = rendered(2, 30, 1, 0.1f);
    set_matte(a, {{{0x11111111, 0.6f}, {0x22222222, 0.4f}}});
    set_matte(b, {{{0x22222222, 0.8f}, {0x33333333, 0.1f}, {0x11111111, 0.04f}}});
    const ExrImage image = merged({a, b});
    const auto id = [&](const char* channel) {
        return std::bit_cast<std::uint32_t>(image.channels.at(channel)[3]);
    };
    EXPECT_EQ(id("objects00.R"), 0x22222222u);
    EXPECT_FLOAT_EQ(image.channels.at("objects00.G")[3], 0.7f);
    EXPECT_EQ(id("objects00.B"), 0x11111111u);
    EXPECT_FLOAT_EQ(image.channels.at("objects00.A")[3], 0.18f);
    EXPECT_EQ(id("objects01.R"), 0x33333333u);
    EXPECT_FLOAT_EQ(image.channels.at("objects01.G")[3], 0.075f);
    EXPECT_EQ(id("objects01.B"), 0u);
    EXPECT_EQ(image.metadata.at("cryptomatte/1234567/name"), "objects");
}

struct Misfit {
    const char* why;
    std::function<void(ExrImage&)> make;
};

TEST(Merger, RefusesWhatDoesNotBelong) {
    const Misfit misfits[] = {
        {"both hold seed 1", [](ExrImage& i) { i.metadata[header::kSeed] = "7 1"; }},
        {"the text of the scene", [](ExrImage& i) { i.metadata[header::kSceneText] = "0"; }},
        {"a mesh, texture", [](ExrImage& i) { i.metadata[header::kSceneFiles] = "0"; }},
        {"the integrator", [](ExrImage& i) { i.metadata[header::kIntegrator] = "path"; }},
        {"a setting", [](ExrImage& i) { i.metadata[header::kSettings] = "0"; }},
        {"does not say its settingsChecksum",
         [](ExrImage& i) { i.metadata.erase(header::kSettings); }},
        {"does not say its samplesPerPixel",
         [](ExrImage& i) { i.metadata.erase(header::kSamples); }},
        {"does not say its seed", [](ExrImage& i) { i.metadata[header::kSeed] = "1,2"; }},
        {"says '-3' of its passes", [](ExrImage& i) { i.metadata[header::kPasses] = "-3"; }},
        {"says 'inf' of its samplesPerPixel",
         [](ExrImage& i) { i.metadata[header::kSamples] = "inf"; }},
        {"differ in size or window", [](ExrImage& i) { i.frame.x = 0; }},
        {"'first.exr' has no channel 'Z'", [](ExrImage& i) { i.channels["Z"].resize(6); }},
        {"'second.exr' has no channel 'G'", [](ExrImage& i) { i.channels.erase("G"); }},
        {"that is no number",
         [](ExrImage& i) { i.channels["B"][3] = std::numeric_limits<float>::quiet_NaN(); }},
    };
    for (const Misfit& misfit : misfits) {
        Merger merger;
        merger.add(rendered(1, 10, 1, 0.1f), "first.exr");
        ExrImage second = rendered(2, 10, 3, 0.1f);
        misfit.make(second);
        try {
            merger.add(second, "second.exr");
            ADD_FAILURE() << "accepted: " << misfit.why;
        } catch (const MergeRefusal& refusal) {
            EXPECT_THAT(refusal.what(), HasSubstr(misfit.why));
        }
        merger.add(rendered(3, 10, 3, 0.1f), "third.exr");
        EXPECT_FLOAT_EQ(merger.merged().channels.at("R")[0], 2) << misfit.why;
    }
}

}  // namespace
}  // namespace lxs::merger_test
