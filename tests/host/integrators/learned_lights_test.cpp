// Protects the learned choice of lights of `path`: the expectation of the choice by power, less
// variance where most lights are hidden, the same bits for any number of threads, and no learning
// under Markov chains.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iostream>

#include "block_test.h"
#include "path_render.h"
#include "run_on_threads.h"

namespace lxs::test::learned_lights_test {
namespace {

constexpr std::size_t kSize = 8;  ///< of the images that render_image gives

std::string lamp(double x, double z) {
    return fmt::format(
               "AttributeBegin\nAreaLightSource \"area\" \"color L\" [5 4 3] \"float power\" [0] "
               "\"float efficacy\" [0]\nTranslate {} 0 0\n",
               x) +
           square(z, 0.3, true) + "AttributeEnd\n";
}

/// A glossy floor, at which shadow rays and bounces find the same lamps; a wall across it with a
/// lamp on either side; and behind a dark ceiling six more that light nothing which is seen.
std::string rooms() {
    std::string scene = camera_above(2.5, 50) + lamp(-1, 2.8) + lamp(1, 2.8);
    for (int i = 0; i < 6; ++i)
        scene += lamp(0.7 * i - 1.8, 5);
    return scene + "Material \"matte\" \"color Kd\" [0.1 0.1 0.1]\n" + square(3, 4, true) +
           "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3]\n"
           "  \"point P\" [0 -4 0  0 4 0  0 4 3  0 -4 3]\n"
           "Material \"glossy\" \"color Kd\" [0.4 0.3 0.3] \"color Ks\" [0.4 0.4 0.4] "
           "\"float uroughness\" [0.3] \"float vroughness\" [0.3]\n" +
           square(0, 4) + "WorldEnd\n";
}

PathSettings choosing(LightStrategy strategy) {
    PathSettings settings;
    settings.lights = strategy;
    return settings;
}

statistics::BlockMeans block_means(LightStrategy strategy, std::uint64_t seed, int passes,
                                   std::size_t block, int renders = 24) {
    statistics::BlockMeans means;
    for (int i = 0; i < renders; ++i) {
        std::vector<double> luminances;
        for (const Rgb& pixel : render_image(rooms(), choosing(strategy), passes, nullptr, seed++))
            luminances.push_back(luminance(pixel));
        means.push_back(statistics::block_means(luminances, kSize, kSize, block));
    }
    return means;
}

/// 17 tests at a family-wise significance of 1 %, fixed seeds; tables are made anew four times.
TEST(LearnedLightsOfPath, SameExpectationAsByPower) {
    const auto plain = block_means(LightStrategy::Power, 100, 768, 2);
    const auto learned = block_means(LightStrategy::Learned, 200, 768, 2);
    const auto same = statistics::compare(plain, learned, 0.01);
    std::cout << same.describe() << "\n";
    EXPECT_FALSE(same.differs()) << same.describe();
    EXPECT_TRUE(statistics::compare(plain, statistics::scaled(learned, 1.02), 0.01).differs())
        << "a planted bias of 2 % went unnoticed";
}

TEST(LearnedLightsOfPath, LessVarianceWhereMostLightsAreHidden) {
    const double gain = statistics::mean_variance(block_means(LightStrategy::Power, 300, 384, 1)) /
                        statistics::mean_variance(block_means(LightStrategy::Learned, 400, 384, 1));
    std::cout << "variance by power / learned: " << gain << "\n";
    EXPECT_GT(gain, 2);
}

/// Lights are learned ahead of it, by paths that must not be those of the pass. 2 tests, fixed
/// seeds.
TEST(LearnedLightsOfPath, FirstPassHasTheSameExpectationAndLessVariance) {
    const auto plain = block_means(LightStrategy::Power, 1000, 1, kSize, 1000);
    const auto learned = block_means(LightStrategy::Learned, 4000, 1, kSize, 1000);
    const auto same = statistics::compare(plain, learned, 0.01);
    std::cout << same.describe() << "\n";
    EXPECT_FALSE(same.differs()) << same.describe();
    EXPECT_TRUE(statistics::compare(plain, statistics::scaled(learned, 1.06), 0.01).differs())
        << "a planted bias of 6 % went unnoticed";
    EXPECT_GT(statistics::mean_variance(plain) / statistics::mean_variance(learned), 2);
}

TEST(LearnedLightsOfPath, SameBitsForAnyNumberOfThreads) {
    std::vector<std::vector<Rgb>> images;
    for (const unsigned threads : {1u, 2u, 7u}) {
        images.push_back(concurrency::run_on(
            threads, [] { return render_image(rooms(), choosing(LightStrategy::Learned), 256); }));
    }
    EXPECT_EQ(images[0], images[1]);
    EXPECT_EQ(images[0], images[2]);
    EXPECT_NE(images[0], render_image(rooms(), choosing(LightStrategy::Power), 256));
}

TEST(LearnedLightsOfPath, MarkovChainsChooseByPower) {
    const std::string scene = "Sampler \"metropolis\"\n" + rooms();
    EXPECT_EQ(render_image(scene, choosing(LightStrategy::Learned), 160),
              render_image(scene, choosing(LightStrategy::Power), 160));
}

}  // namespace
}  // namespace lxs::test::learned_lights_test
