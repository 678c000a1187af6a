// Protects the views of what a render has learned: which light shadow rays ask where, and the
// regions of the adaptive guide's tables; and that looking changes no bit.
#include <gtest/gtest.h>

#include <numeric>

#include "layers/light_layers.h"
#include "layers/table_layers.h"
#include "render_mock.h"
#include "run_on_threads.h"

namespace aips::learned_layers_test {
namespace {

using Layer = std::vector<float>;

/// A box with a lamp at the left of its ceiling and a dimmer one at the right.
mock::Scene left_and_right() {
    mock::Scene scene;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, {});
    for (const float x : {-0.8f, 0.4f}) {
        mock::Surface lamp;
        lamp.shape = mock::Quad{{x, -0.3f, 0.98f}, {0, 0.6f, 0}, {0.4f, 0, 0}};
        lamp.material.reflectance = {0, 0, 0};
        lamp.emitted = x < 0 ? Rgb{3, 3, 3} : Rgb{1, 1, 1};
        scene.add(lamp);
    }
    scene.finish();
    return scene;
}

VisiblePoint point_at(Vec3 position, std::uint32_t path, Vec3 normal = {0, 0, 1}) {
    VisiblePoint point;
    point.position = position;
    point.geometric_normal = normal;
    point.wo = normal;
    point.sample = path;
    return point;
}

/// Pixels 0 and 1 of 3 x 1 have a point at the left and one at the right; 2 has none.
EyeImage seen() {
    EyeImage image;
    image.positions = {{0.5f, 0.5f}, {1.5f, 0.5f}, {2.5f, 0.5f}};
    image.visible_points = {point_at({-0.9f, 0, -1}, 0), point_at({0.9f, 0, -1}, 1)};
    return image;
}

TEST(LightLayers, ShowTheChoiceByPowerAndThenWhatWasLearned) {
    const mock::Scene scene = left_and_right();
    DirectLight lights(scene, true);
    ASSERT_TRUE(lights.learned());
    mock::Film film(3, 1);
    LightLayers layers(film);
    layers.show(seen(), lights);
    EXPECT_EQ(film.layers().at("lightchoice"), (Layer{1, 1, 0}));
    EXPECT_NEAR(film.layers().at("lightshare")[0], 0.75f, 1e-4f);
    EXPECT_EQ(film.layers().at("lightshare")[2], 0);
    std::vector<LightSample> told;
    for (int i = 0; i < 20'000; ++i) {
        const float x = 2 * (float(i % 1000) + 0.5f) / 1000 - 1;
        const std::uint32_t light = i / 1000 % 2;
        const bool near = (x < 0) == (light == 0);
        told.push_back({{x, 0, -1}, {0, 0, 1}, light, 0.5f, near ? 1.0f : 0.0f});
    }
    // Places are halved a level at a time.
    for (std::uint64_t passes = 1; passes <= 10; ++passes)
        lights.learn(told, told.size(), passes);
    layers.show(seen(), lights);
    EXPECT_EQ(film.layers().at("lightchoice"), (Layer{1, 2, 0}));
    EXPECT_GT(film.layers().at("lightshare")[1], 0.6f);
}

TEST(LightLayers, AreLeftOutWhereThereIsNothingToLearn) {
    const mock::Scene scene = mock::lamp_box({}, {});
    EXPECT_FALSE(DirectLight(scene, true).learned());
    EXPECT_FALSE(DirectLight(left_and_right(), false).learned());
}

TEST(TableLayers, RegionsEndWhereNormalsDiffer) {
    BounceTables tables(Bounds{{-1, -1, -1}, {1, 1, 1}});
    mock::Film film(3, 2);
    EyeImage image;
    const std::vector<std::uint32_t> pixels{0, 1, 2, 3};
    image.positions.resize(4);
    image.visible_points = {point_at({0, 0, -1}, 0), point_at({0.01f, 0, -1}, 1),
                            point_at({1, 0, 0}, 2, {-1, 0, 0}), point_at({0, 0.01f, -1}, 3)};
    // Seen from behind, a surface has the region of that side.
    image.visible_points[3].geometric_normal = {0, 0, -1};
    TableLayers layers(film);
    layers.show(image, pixels, tables);
    EXPECT_EQ(film.layers().at("tableedges"), (Layer{0, 1, 1, 0, 0, 0}));
    EXPECT_EQ(film.layers().at("tableshare"), Layer(6)) << "nothing was learned";
}

Settings adaptive(bool layers) {
    Settings settings = mock::small_settings(3, 20000);
    settings.guide = GuideKind::Adaptive;
    settings.debug_layers = layers;
    return settings;
}

mock::Rendering render(bool layers) {
    const mock::Scene scene = left_and_right();
    const auto camera = mock::camera_along_y({0, -0.95f, 0}, 1, 32, 24);
    return mock::render(scene, camera, 32, 24, adaptive(layers), 4);
}

TEST(TableLayers, ShowTheAdaptiveGuideAndChangeNoBit) {
    const auto off = render(false), on = render(true);
    EXPECT_EQ(off.film.image(), on.film.image());
    EXPECT_TRUE(off.film.layers().empty());
    const Layer& edges = on.film.layers().at("tableedges");
    const float sum = std::accumulate(edges.begin(), edges.end(), 0.0f);
    EXPECT_GT(sum, 0);
    EXPECT_LT(sum, float(edges.size()));
    for (const float share : on.film.layers().at("tableshare"))
        EXPECT_TRUE(share >= 0 && share <= 1) << share;
    EXPECT_LE(on.statistics.memory_bytes, on.statistics.memory_bound_bytes);
    EXPECT_LE(on.statistics.memory_bytes - off.statistics.memory_bytes,
              on.statistics.memory_bound_bytes - off.statistics.memory_bound_bytes);
}

TEST(TableLayers, SameBitsForAnyNumberOfThreads) {
    const auto one = concurrency::run_on(1, [] { return render(true); });
    const auto five = concurrency::run_on(5, [] { return render(true); });
    EXPECT_EQ(one.film.layers(), five.film.layers());
}

}  // namespace
}  // namespace aips::learned_layers_test
