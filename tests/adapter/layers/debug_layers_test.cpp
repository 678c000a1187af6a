// Protects the debug layers: the image is the photon part plus the eye part, densities have their
// stated unit, and looking at a render neither changes it nor depends on the number of threads.
#include <gtest/gtest.h>

#include <numbers>

#include "aips/core/sampling/sampling.h"
#include "render_mock.h"
#include "run_on_threads.h"

namespace aips::debug_layers_test {
namespace {

constexpr std::uint32_t kWidth = 32, kHeight = 24;

/// A box with a half mirroring ball and a lamp of light group 1 beside that of group 0.
mock::Scene two_lamps() {
    mock::Scene scene;
    scene.set_light_groups(2);
    scene.add_box({-1, -1, -1}, {1, 1, 1}, {});
    mock::Surface ball;
    ball.shape = mock::Ball{{0.35f, 0.3f, -0.6f}, 0.4f, false};
    ball.material.kind = mock::Material::Kind::LambertAndMirror;
    ball.material.specular = {0.3f, 0.3f, 0.3f};
    scene.add(ball);
    for (std::uint32_t group = 0; group < 2; ++group) {
        mock::Surface lamp;
        const float x = group ? 0.4f : -0.8f;
        lamp.shape = mock::Quad{{x, -0.3f, 0.98f}, {0, 0.6f, 0}, {0.4f, 0, 0}};
        lamp.material.reflectance = {0, 0, 0};
        lamp.emitted = group ? Rgb{2, 4, 6} : Rgb{9, 6, 3};
        lamp.light_group = group;
        scene.add(lamp);
    }
    scene.finish();
    return scene;
}

struct Method {
    const char* name;
    GuideKind guide;
    Mode mode;

    friend std::ostream& operator<<(std::ostream& out, const Method& m) { return out << m.name; }
};

class DebugLayers : public testing::TestWithParam<Method> {
  protected:
    static Settings settings(bool layers) {
        Settings settings = mock::small_settings(7, 20000);
        settings.guide = GetParam().guide;
        settings.mode = GetParam().mode;
        settings.iteration_photons = 2000;
        settings.max_nodes = 512;
        settings.debug_layers = layers;
        return settings;
    }
    /// Eye paths that are traced once have nothing to learn for.
    static bool learns_lights() { return GetParam().mode == Mode::Progressive; }
    static mock::Rendering render(const Settings& settings, std::uint32_t passes = 3) {
        const mock::Scene scene = two_lamps();
        const auto camera = mock::camera_along_y({0, -0.95f, 0}, 1, kWidth, kHeight);
        return mock::render(scene, camera, kWidth, kHeight, settings, passes);
    }
};

INSTANTIATE_TEST_SUITE_P(Methods, DebugLayers,
                         testing::Values(Method{"sppm", GuideKind::None, Mode::Progressive},
                                         Method{"photonmap", GuideKind::None, Mode::PhotonMap},
                                         Method{"paper", GuideKind::Paper, Mode::Progressive},
                                         Method{"paper_photonmap", GuideKind::Paper,
                                                Mode::PhotonMap}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(DebugLayers, ImageIsPhotonPartPlusWhatTheEyePassGaveAlone) {
    // Paths that go on meet lights on their way, so that shadow rays do with less.
    Settings photons_alone = settings(true);
    photons_alone.continue_eye_paths = false;
    const auto all = render(photons_alone);
    Settings no_photons = settings(false);
    no_photons.max_photon_depth = 1;  // shadow rays carry all of that
    const auto eye = render(no_photons).film.image();
    ASSERT_EQ(all.film.color_layers().count("photons"), 1u);
    const auto photons = all.film.color_layers().at("photons").image();
    const auto image = all.film.image();
    double photon_sum = 0, image_sum = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Rgb &total = image[i], &part = photons[i];
        EXPECT_NEAR(total.r - part.r, eye[i].r, 2e-6f * total.r) << "pixel " << i;
        EXPECT_NEAR(total.g - part.g, eye[i].g, 2e-6f * total.g) << "pixel " << i;
        EXPECT_NEAR(total.b - part.b, eye[i].b, 2e-6f * total.b) << "pixel " << i;
        photon_sum += luminance(part);
        image_sum += luminance(total);
    }
    EXPECT_GT(photon_sum, 0.1 * image_sum) << "a scene without photons would prove nothing";
    EXPECT_LT(photon_sum, 0.9 * image_sum);
}

TEST_P(DebugLayers, WithoutPhotonsTheirLayersAreBlack) {
    Settings no_photons = settings(true);
    no_photons.max_photon_depth = 1;
    const auto r = render(no_photons);
    EXPECT_EQ(r.film.color_layers().at("photons").mean(), 0);
    EXPECT_EQ(r.film.layers().size(), learns_lights() ? 3u : 1u)
        << "a guide that is not needed has no nodes";
    EXPECT_EQ(r.film.layers().contains("lightchoice"), learns_lights());
    EXPECT_EQ(r.film.layers().contains("lightshare"), learns_lights());
    EXPECT_EQ(r.film.layers().at("photondensity"),
              std::vector<float>(std::size_t{kWidth} * kHeight, 0.0f));
}

TEST_P(DebugLayers, LeaveTheImageAsItIs) {
    const auto off = render(settings(false));
    EXPECT_EQ(off.film.image(), render(settings(true)).film.image());
    EXPECT_TRUE(off.film.layers().empty());
    EXPECT_TRUE(off.film.color_layers().empty());
}

TEST_P(DebugLayers, SameBitsForAnyNumberOfThreads) {
    const auto rendered_with = [](unsigned threads) {
        return concurrency::run_on(threads, [] { return render(settings(true)); });
    };
    const auto one = rendered_with(1);
    for (const unsigned threads : {2u, 7u}) {
        const auto other = rendered_with(threads);
        EXPECT_EQ(one.film.layers(), other.film.layers()) << threads;
        EXPECT_EQ(one.film.color_layers().at("photons").image(),
                  other.film.color_layers().at("photons").image());
    }
}

TEST_P(DebugLayers, AreFiniteAndInTheirRanges) {
    const auto r = render(settings(true));
    std::vector<std::string> names;
    for (const auto& [name, values] : r.film.layers()) {
        names.push_back(name);
        double sum = 0;
        for (const float value : values) {
            EXPECT_TRUE(std::isfinite(value) && value >= 0) << name << " " << value;
            EXPECT_TRUE(name != "guidedshare" || value <= 1) << value;
            EXPECT_TRUE(name != "lightshare" || value <= 1) << value;
            EXPECT_TRUE(name != "lightchoice" || value == 1 || value == 2) << value;
            EXPECT_TRUE(name != "nodeedges" || value == 0 || value == 1) << value;
            sum += value;
        }
        EXPECT_GT(sum, 0) << name;
    }
    std::vector<std::string> expected{"photondensity"};
    if (learns_lights()) expected.insert(expected.end(), {"lightchoice", "lightshare"});
    if (GetParam().guide == GuideKind::Paper)
        expected.insert(expected.end(), {"guidedshare", "nodeedges", "nodeerror", "nodeweight"});
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(names, expected);
    for (const Rgb& pixel : r.film.color_layers().at("photons").image())
        EXPECT_TRUE(is_valid_radiance(pixel));
}

TEST_P(DebugLayers, StayWithinTheMemoryBound) {
    // By then vectors fit the greatest pass.
    const auto early = render(settings(true), 24).statistics;
    const auto late = render(settings(true), 48).statistics;
    EXPECT_LE(late.memory_bytes, late.memory_bound_bytes);
    EXPECT_LE(double(late.memory_bytes), 1.02 * double(early.memory_bytes));
    const auto off = render(settings(false), 24).statistics;
    EXPECT_LE(early.memory_bytes - off.memory_bytes,
              early.memory_bound_bytes - off.memory_bound_bytes)
        << "what the layers take is what they add to the bound";
}

/// Over the image the nodes' shares average to about that of all bounces; without a guided share
/// there is none.
TEST(GuidedShare, FollowsTheMixture) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const auto camera = mock::camera_along_y({0, -0.95f, 0}, 1, kWidth, kHeight);
    for (const double share : {0.0, 0.3, 0.9}) {
        Settings settings = mock::small_settings(9, 20000);
        settings.guide = GuideKind::Paper;
        settings.guide_share = share;
        settings.node_photons = 512;  // nodes of many bounces
        settings.debug_layers = true;
        const auto r = mock::render(scene, camera, kWidth, kHeight, settings, 1);
        double mean = 0;
        for (const float value : r.film.layers().at("guidedshare"))
            mean += value / double(kWidth * kHeight);
        const double of_all = double(r.statistics.guided_bounces) / double(r.statistics.bounces);
        EXPECT_NEAR(mean, of_all, 0.03) << "guideshare " << share;
        EXPECT_NEAR(of_all, share * 0.95, 0.03) << "all but the first 1000 of 20000 are guided";
    }
}

/// A point light h before a wall: N photons bring N cos / (4 pi d^2) per unit of area. 2 m paths
/// bring 2500 photons to a pixel (2 % in the worst case of independence, 10 % is five sigma) and
/// 80000 to the wall that is seen (0.35 %, 1.5 % is four); the finite radius lowers it by 0.2 %.
TEST(PhotonDensity, OfAPointLightBeforeAWall) {
    constexpr std::uint32_t kSize = 16;
    constexpr double kHeightOfLight = 1;
    constexpr double kHalf = 0.1;
    mock::Scene scene;
    mock::Surface wall;
    wall.shape = mock::Quad{{-4, 2, -4}, {8, 0, 0}, {0, 0, 8}};
    scene.add(wall);
    scene.add_point_light({0, 2 - float(kHeightOfLight), 0}, {1, 2, 3});
    scene.finish();
    Settings settings = mock::small_settings(5, 100000);
    settings.direct_light_sampling = false;
    settings.max_photon_depth = 1;
    settings.start_radius = 2;
    settings.debug_layers = true;
    const auto camera = mock::camera_along_y({0, 0, 0}, float(kHalf), kSize, kSize);
    const auto r = mock::render(scene, camera, kSize, kSize, settings, 20);
    const std::vector<float>& layer = r.film.layers().at("photondensity");
    double measured = 0, expected = 0;
    for (std::size_t i = 0; i < layer.size(); ++i) {
        const std::size_t column = i % kSize, row = i / kSize;
        const double x = 2 * kHalf * (2 * (double(column) + 0.5) / kSize - 1);
        const double z = 2 * kHalf * (2 * (double(row) + 0.5) / kSize - 1);
        const double d = std::sqrt(x * x + z * z + kHeightOfLight * kHeightOfLight);
        const double density = 100000 * kHeightOfLight / (4 * std::numbers::pi * std::pow(d, 3));
        EXPECT_NEAR(layer[i], density, 0.1 * density) << "pixel " << i;
        measured += layer[i];
        expected += density;
    }
    EXPECT_NEAR(measured, expected, 0.015 * expected);
}

}  // namespace
}  // namespace aips::debug_layers_test
