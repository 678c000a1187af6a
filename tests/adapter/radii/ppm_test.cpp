// Protects mode=ppm as a whole: the image that stochastic progressive photon mapping converges to,
// with a bias that falls from pass to pass; light groups; radii that only light shrinks.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "block_test.h"
#include "render_mock.h"

namespace aips::ppm_test {
namespace {

constexpr std::uint32_t kSize = 32;

Settings ppm_settings(std::uint64_t seed, std::uint32_t photons) {
    Settings settings = mock::small_settings(seed, photons);
    settings.mode = Mode::Ppm;
    settings.alpha = 0.7;
    // As in the paper: all light comes from photons, none of the noise is frozen with the points.
    settings.direct_light_sampling = false;
    return settings;
}

/// Block means of the lower half: floor and ball, without the lamp that eye rays see.
std::vector<double> floor_blocks(const mock::Rendering& rendering) {
    std::vector<double> luminances = mock::luminances(rendering.film);
    luminances.erase(luminances.begin(), luminances.begin() + kSize * kSize / 2);
    return statistics::block_means(luminances, kSize, kSize / 2, 4);
}

double mean_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::abs(a[i] / b[i] - 1);
    return sum / double(a.size());
}

TEST(Ppm, ConvergesToTheImageOfSppm) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, kSize, kSize);
    Settings sppm = ppm_settings(61, 100'000);
    sppm.mode = Mode::Progressive;
    sppm.correct_edges = false;
    sppm.start_radius = 0.5;
    const auto reference = floor_blocks(mock::render(scene, camera, kSize, kSize, sppm, 20));
    Settings ppm = ppm_settings(62, 4000);
    ppm.start_radius = 4;
    ppm.alpha = 0.5;
    std::vector<double> sequence;
    for (const std::uint32_t passes : {2u, 24u, 288u}) {
        const auto image = floor_blocks(mock::render(scene, camera, kSize, kSize, ppm, passes));
        sequence.push_back(mean_difference(image, reference));
        std::cout << passes << " passes: mean block difference " << 100 * sequence.back() << " %\n";
    }
    EXPECT_LT(sequence[1], 0.6 * sequence[0]);
    EXPECT_LT(sequence[2], 0.6 * sequence[1]);
    EXPECT_LT(sequence[2], 0.025);
}

TEST(Ppm, LightShrinksTheRadiusInEachPass) {
    const auto r = mock::radii(mock::lamp_box({}, {}), ppm_settings(63, 20000), 4);
    for (std::size_t i = 1; i < r.size(); ++i)
        EXPECT_LT(r[i], r[i - 1]);
}

/// Walls that absorb all photons, gathered as Lambertian points and by a general Bsdf.
TEST(Ppm, RejectedPhotonsDoNotShrinkTheRadius) {
    mock::Material black;
    black.reflectance = {0, 0, 0};
    for (const bool hide : {false, true}) {
        black.hide_lambert = hide;
        const auto r = mock::radii(mock::lamp_box(black, black), ppm_settings(64, 20000), 4);
        EXPECT_GT(r[0], 0);
        EXPECT_EQ(r.back(), r.front()) << "general Bsdf " << hide;
    }
}

/// Light groups share a point's radius: their images add up to the one of a single group.
TEST(Ppm, LightGroupsAddUp) {
    const auto rendered = [](std::uint32_t groups) {
        mock::Scene scene;
        scene.add_box({-1, -1, -1}, {1, 1, 1}, {});
        for (std::uint32_t i = 0; i < 2; ++i) {
            mock::Surface lamp;
            lamp.shape = mock::Ball{{i ? 0.6f : -0.6f, 0.3f, 0.5f}, 0.1f, false};
            lamp.material.reflectance = {0, 0, 0};
            lamp.emitted = i ? Rgb{9, 3, 1} : Rgb{1, 2, 8};
            lamp.light_group = groups > 1 ? i : 0;
            scene.add(lamp);
        }
        scene.set_light_groups(groups);
        scene.finish();
        const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, kSize, kSize);
        return mock::render(scene, camera, kSize, kSize, ppm_settings(65, 20000), 4);
    };
    const auto together = rendered(1), apart = rendered(2);
    const auto whole = together.film.image(), sum = apart.film.image();
    EXPECT_EQ(together.statistics.radius, apart.statistics.radius);
    for (std::size_t i = 0; i < whole.size(); ++i)
        EXPECT_NEAR(sum[i].g, whole[i].g, 1e-4f * (1 + whole[i].g));
    for (const int g : {0, 1}) {
        double total = 0;
        for (const Rgb& pixel : apart.film.image_of_group(g))
            total += luminance(pixel);
        EXPECT_GT(total, 0);
    }
}

}  // namespace
}  // namespace aips::ppm_test
