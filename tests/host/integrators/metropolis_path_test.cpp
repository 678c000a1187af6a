// Protects `path` under Sampler "metropolis": the expectation of plain path tracing, the same bits
// for any number of threads, closed forms, light groups and figures.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>

#include "block_test.h"
#include "path_render.h"
#include "run_on_threads.h"
#include "test_form.h"

namespace lxs::test::metropolis_path_test {
namespace {

const std::string kMetropolis = "Sampler \"metropolis\"\n";
constexpr std::size_t kSize = 8;  ///< of the images that render_image gives

/// A glossy floor, a glass ball with its caustic, a lamp, a dim sky of its own light group.
std::string still_life() {
    return camera_above(4, 50) +
           "AttributeBegin\nAreaLightSource \"area\" \"color L\" [2 1.6 1.2] \"float power\" [0] "
           "\"float efficacy\" [0]\nTranslate 1 0 0\n" +
           square(3, 1.2, true) +
           "AttributeEnd\nLightGroup \"sky\"\nLightSource \"infinite\" \"color L\" [.1 .1 .2]\n"
           "LightGroup \"\"\nAttributeBegin\nMaterial \"glass\" \"float index\" [1.5]\n"
           "Translate 0.4 0.3 0.6\nShape \"sphere\" \"float radius\" [0.5]\nAttributeEnd\n"
           "Material \"glossy\" \"color Kd\" [0.5 0.3 0.3] \"color Ks\" [0.3 0.3 0.3] "
           "\"float uroughness\" [0.2] \"float vroughness\" [0.2]\n" +
           square(0, 4) + "WorldEnd\n";
}

statistics::BlockMeans block_means(const std::string& scene, int passes, std::uint64_t seed,
                                   int renders = 10) {
    statistics::BlockMeans means;
    for (int i = 0; i < renders; ++i) {
        std::vector<double> luminances;
        for (const Rgb& pixel : render_image(scene, {}, passes, nullptr, seed++))
            luminances.push_back(luminance(pixel));
        means.push_back(statistics::block_means(luminances, kSize, kSize, 2));
    }
    return means;
}

// 17 tests a sampler at a family-wise significance of 1e-3, fixed seeds.
TEST(MetropolisPath, HasTheExpectationOfPlainPaths) {
    const auto plain = block_means(still_life(), statistics::sized(1500, 4096), 100);
    for (const std::string sampler :
         {"Sampler \"metropolis\"\n", "Sampler \"metropolis\" \"float largemutationprob\" [0.1]\n",
          "Sampler \"metropolis\" \"float largemutationprob\" [1]\n",
          "Sampler \"metropolis\" \"float mutationrange\" [4]\n"}) {
        const auto chains = block_means(sampler + still_life(), statistics::sized(750, 2048), 200);
        const auto same = statistics::compare(plain, chains, 1e-3);
        std::cout << sampler << "  " << same.describe() << "\n";
        EXPECT_FALSE(same.differs()) << same.describe();
        const double planted = statistics::sized(0.035, 0.02);
        EXPECT_TRUE(
            statistics::compare(plain, statistics::scaled(chains, 1 + planted), 1e-3).differs())
            << "a planted bias went unnoticed";
    }
}

// Chains that started anywhere but in proportion to brightness would show it before they forget: a
// lamp before a sky thirty times dimmer.
TEST(MetropolisPath, FirstPassHasTheExpectationToo) {
    const std::string scene = camera_above(4, 50) +
                              "LightSource \"infinite\" \"color L\" [.3 .3 .3]\n" +
                              "AreaLightSource \"area\" \"color L\" [9 9 9] \"float power\" [0] "
                              "\"float efficacy\" [0]\nMaterial \"matte\" \"color Kd\" [0 0 0]\n" +
                              square(0, 0.8) + "WorldEnd\n";
    const auto plain = block_means(scene, 256, 100);
    const auto first = block_means(
        "Sampler \"metropolis\" \"float largemutationprob\" [0.02]\n" + scene, 1, 1000, 200);
    const auto same = statistics::compare(plain, first, 1e-3);
    std::cout << same.describe() << "\n";
    EXPECT_FALSE(same.differs()) << same.describe();
}

// The furnace of path_closed_form_test: albedo 0.5, radiance 1, every depth.
TEST(MetropolisPath, FurnaceSumsTheBouncesThatMaxdepthAllows) {
    const std::string furnace =
        kMetropolis + camera_above(0.3, 60) +
        "Material \"matte\" \"color Kd\" [0.5 0.5 0.5]\n"
        "AreaLightSource \"area\" \"color L\" [1 1 1] \"float power\" [0] "
        "\"float efficacy\" [0]\n"
        "ReverseOrientation\nShape \"sphere\" \"float radius\" [2]\nWorldEnd\n";
    for (const std::uint32_t depth : {0u, 1u, 16u}) {
        PathSettings settings;
        settings.max_depth = depth;
        const double expected = (1 - std::pow(0.5, depth + 1)) / 0.5;
        double sum = 0;
        for (const Rgb& pixel : render_image(furnace, settings, 1024))
            sum += pixel.y;
        EXPECT_NEAR(sum / (kSize * kSize) / expected, 1, 0.01) << "depth " << depth;
    }
}

TEST(MetropolisPath, SameBitsForAnyNumberOfThreads) {
    std::vector<std::vector<Rgb>> images;
    for (const unsigned threads : {1u, 2u, 7u}) {
        images.push_back(concurrency::run_on(
            threads, [] { return render_image(kMetropolis + still_life(), {}, 20); }));
    }
    EXPECT_EQ(images[0], images[1]);
    EXPECT_EQ(images[0], images[2]);
    EXPECT_NE(images[0], render_image(kMetropolis + still_life(), {}, 20, nullptr, 2));
}

TEST(MetropolisPath, FiguresAreSane) {
    Statistics statistics;
    for (const Rgb& pixel : render_image(kMetropolis + still_life(), {}, 64, &statistics)) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_TRUE(std::isfinite(pixel[c]));
            EXPECT_GE(pixel[c], 0);
        }
    }
    const std::map<std::string, Statistics::value_type::second_type> of(statistics.begin(),
                                                                        statistics.end());
    const auto count = [&](const char* name) { return std::get<std::uint64_t>(of.at(name)); };
    const auto figure = [&](const char* name) { return std::get<double>(of.at(name)); };
    EXPECT_EQ(count("metropolis mutations"), 64 * kSize * kSize);
    // 16 chains, 4 of which the large steps of 64 passes were enough to renew once: each start
    // traces its path again, except those that no pass has come to.
    EXPECT_EQ(count("metropolis chain starts"), 20u);
    EXPECT_EQ(count("paths"), count("metropolis mutations") + 16384 + 20);
    EXPECT_EQ(count("refused contributions"), 0u);
    EXPECT_GT(figure("metropolis acceptance rate"), 0.1);
    EXPECT_LT(figure("metropolis acceptance rate"), 1);
    EXPECT_GT(figure("metropolis acceptance rate of small steps"),
              figure("metropolis acceptance rate of large steps"));
    EXPECT_GT(count("metropolis plain samples for b"), 16384u);
    EXPECT_GT(figure("metropolis b"), 0);
}

}  // namespace
}  // namespace lxs::test::metropolis_path_test
