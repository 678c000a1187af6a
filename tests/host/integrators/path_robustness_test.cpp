// Protects determinism, and that nothing but finite light reaches the film.
#include <gtest/gtest.h>

#include <cmath>

#include "path/path_integrator.h"
#include "path_render.h"
#include "run_on_threads.h"

namespace lxs::test::path_robustness_test {
namespace {

std::string lit_spheres() {
    return camera_above(6, 40) +
           "AttributeBegin\nAreaLightSource \"area\" \"color L\" [5 4 3] \"float power\" [0] "
           "\"float efficacy\" [0]\n" +
           square(3, 1, true) +
           "AttributeEnd\nLightGroup \"sky\"\nLightSource \"infinite\" \"color L\" [1 1 2]\n"
           "LightGroup \"\"\nMaterial \"glass\"\nShape \"sphere\" \"float radius\" [0.8]\n"
           "Translate 1.5 0 0\nMaterial \"mirror\"\nShape \"sphere\" \"float radius\" [0.7]\n"
           "Material \"matte\"\n" +
           square(-1, 9) + "WorldEnd\n";
}

TEST(PathRobustness, SameBitsForAnyNumberOfThreads) {
    std::vector<std::vector<Rgb>> images;
    for (const unsigned threads : {1u, 2u, 7u}) {
        images.push_back(
            concurrency::run_on(threads, [] { return render_image(lit_spheres(), {}, 8); }));
    }
    EXPECT_EQ(images[0], images[1]);
    EXPECT_EQ(images[0], images[2]);
}

TEST(PathRobustness, HealthySceneGivesFiniteLightAndRefusesNothing) {
    Statistics statistics;
    for (const Rgb& pixel : render_image(lit_spheres(), {}, 64, &statistics)) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_TRUE(std::isfinite(pixel[c]));
            EXPECT_GE(pixel[c], 0);
        }
    }
    for (const auto& [name, value] : statistics) {
        if (name == "refused contributions") {
            EXPECT_EQ(std::get<std::uint64_t>(value), 0u);
        }
    }
}

}  // namespace
}  // namespace lxs::test::path_robustness_test
