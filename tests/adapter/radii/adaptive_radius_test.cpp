// Protects radius=adaptive: radii come from earlier passes' probes alone, balance what those found,
// and stay within bounds that keep the estimate consistent.
#include "radii/adaptive_radius.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "aips/core/sampling/random.h"
#include "plan/flat_memory.h"
#include "radii/curvature_probes.h"
#include "radii/scheduled_radius.h"
#include "render_mock.h"
#include "run_on_threads.h"

namespace aips::adaptive_radius_test {
namespace {

constexpr std::uint32_t kSize = 24;
constexpr float kPixel = 0.05f;  // width of a pixel on the plane that it sees

Settings settings_with(std::uint32_t photons) {
    Settings settings = mock::small_settings(1, photons);
    settings.radius = RadiusKind::Adaptive;
    settings.alpha = 0.7;
    return settings;
}

/// One white Lambertian point in the middle of each pixel of a film that looks down on z = 0, with
/// the origin in the middle.
EyeImage plane_image() {
    EyeImage image;
    for (std::uint32_t i = 0; i < kSize * kSize; ++i) {
        const std::uint32_t x = i % kSize, y = i / kSize;
        const Vec2 film{float(x) + 0.5f, float(y) + 0.5f};
        VisiblePoint point;
        point.position = {(film.x - 0.5f * kSize) * kPixel, (film.y - 0.5f * kSize) * kPixel, 0};
        point.geometric_normal = point.shading_normal = point.wo = {0, 0, 1};
        point.kd = point.throughput = kWhite;
        point.sample = i;
        image.positions.push_back(film);
        image.visible_points.push_back(point);
    }
    image.radiance.assign(image.positions.size(), Rgb{});
    image.footprint_sum = 0.5 * double(kPixel) * double(image.visible_points.size());
    return image;
}

AdaptiveRadius policy(const Settings& settings) {
    return {settings, mock::lamp_box({}, {}), kSize, kSize};
}

/// Photons spread evenly over a disc, each worth `value`, more by `excess` (a share) in the outer
/// half of its area and less in the inner half.
ProbeSums probe_of(double excess, int photons, double value) {
    ProbeSums sums;
    for (int i = 0; i < photons; ++i) {
        const double share = (i + 0.5) / photons;
        sums.add(value * (1 + (share > 0.5 ? excess : -excess)), share);
    }
    return sums;
}

/// The same in all probes.
PhotonFlux flux_with(const GatherRadii& radii, const ProbeSums& sums) {
    PhotonFlux flux;
    flux.wants_inner = true;
    flux.reset(std::size_t{kSize} * kSize, 1, radii.probes.size());
    std::fill(flux.probes.begin(), flux.probes.end(), sums);
    return flux;
}

PassPhotons photons_of(const Settings& settings, std::uint64_t pass) {
    return {pass * settings.photons_per_pass, settings.photons_per_pass};
}

float scheduled(const Settings& settings, std::uint64_t pass) {
    const double initial = initial_radius(settings, plane_image(), 1e-9);
    return scheduled_radius(settings, initial, double(pass) * settings.photons_per_pass, 1e-9);
}

TEST(AdaptiveRadius, FollowsTheScheduleUntilPhotonsAreSeen) {
    const EyeImage image = plane_image();
    const Settings settings = settings_with(1000000);
    AdaptiveRadius adaptive = policy(settings);
    for (std::uint64_t pass = 0; pass < 4; ++pass) {
        const GatherRadii radii = adaptive.before_pass(photons_of(settings, pass), image);
        for (std::size_t i = 0; i < image.visible_points.size(); ++i)
            EXPECT_FLOAT_EQ(radii.of(i), scheduled(settings, pass));
        adaptive.after_pass(flux_with(radii, ProbeSums{}));
    }
}

TEST(AdaptiveRadius, ProbesEveryPixelOnceInSixteenPasses) {
    const EyeImage image = plane_image();
    const Settings settings = settings_with(1000);
    AdaptiveRadius adaptive = policy(settings);
    std::multiset<std::uint32_t> probed;
    for (std::uint64_t pass = 0; pass < 16; ++pass) {
        const GatherRadii radii = adaptive.before_pass(photons_of(settings, pass), image);
        EXPECT_EQ(radii.probes.size(), kSize * kSize / 16);
        probed.insert(radii.probes.begin(), radii.probes.end());
        adaptive.after_pass(flux_with(radii, probe_of(0, 1, 1)));
    }
    for (std::uint32_t i = 0; i < kSize * kSize; ++i)
        EXPECT_EQ(probed.count(i), 1u);
}

/// Even light under a fast schedule: as wide as allowed. An edge under a constant one: as narrow as
/// allowed in the end. 10 000 passes later radii still are ordinary numbers.
TEST(AdaptiveRadius, StaysWithinBoundsOfTheSchedule) {
    const EyeImage image = plane_image();
    Settings settings = settings_with(100000);
    for (const double excess : {0.0, 1.0}) {
        settings.alpha = excess > 0 ? 1 : 0.3;
        AdaptiveRadius adaptive = policy(settings);
        const ProbeSums sums = probe_of(excess, 10000, 1e-3);
        float least = 1e30f, greatest = 0;
        for (std::uint64_t pass = 0; pass < 10000; ++pass) {
            const GatherRadii radii = adaptive.before_pass(photons_of(settings, pass), image);
            const float ratio = radii.of(0) / scheduled(settings, pass);
            least = std::min(least, ratio);
            greatest = std::max(greatest, ratio);
            ASSERT_TRUE(std::isnormal(radii.of(0)) && radii.of(0) > 0) << pass;
            ASSERT_LE(radii.of(0), radii.largest);
            adaptive.after_pass(flux_with(radii, sums));
        }
        EXPECT_GE(least, 0.125f * 0.9999f);
        EXPECT_LE(greatest, 2 * 1.0001f);
        if (excess == 0) {
            EXPECT_GT(greatest, 1.95f);
        } else {
            EXPECT_LT(least, 0.126f);
        }
    }
}

/// Sums that overflow or underflow say nothing: the schedule stays.
TEST(AdaptiveRadius, IgnoresWhatIsNotANumber) {
    const EyeImage image = plane_image();
    const Settings settings = settings_with(1000);
    for (const double value : {1e-200, 1e200}) {
        AdaptiveRadius adaptive = policy(settings);
        adaptive.after_pass(flux_with(adaptive.before_pass(photons_of(settings, 0), image),
                                      probe_of(0.3, 10, value)));
        EXPECT_FLOAT_EQ(adaptive.before_pass(photons_of(settings, 1), image).of(0),
                        scheduled(settings, 1));
    }
}

/// Photons on the plane with density (per unit area, per path) c (1 + k (x^2 + y^2)) on a square.
std::vector<Photon> quadratic_photons(double k, double half, int count, std::uint64_t seed) {
    std::vector<Photon> photons;
    RandomStream random(seed, 0, 0, RandomDomain::Photon);
    while (int(photons.size()) < count) {
        const double x = half * (2 * double(random.next()) - 1);
        const double y = half * (2 * double(random.next()) - 1);
        if (double(random.next()) * (1 + 2 * k * half * half) > 1 + k * (x * x + y * y)) continue;
        Photon photon;
        photon.position = {float(x), float(y), 0};
        photon.direction = photon.normal = {0, 0, 1};
        photon.power = {2, 2, 2};
        photons.push_back(photon);
    }
    return photons;
}

/// Through the whole chain of grid, probes and map, in the middle of a bowl of light: the radius is
/// that of the closed form, to the error of 40 passes' probes (well below 10 % of the Laplacian;
/// the radius takes a third of it).
TEST(AdaptiveRadius, FindsTheOptimumOfAKnownDensity) {
    constexpr double kCurvature = 4, kHalf = 1.5;
    constexpr int kPhotons = 60000, kPasses = 40;
    const EyeImage image = plane_image();
    const Settings settings = settings_with(kPhotons);
    AdaptiveRadius adaptive = policy(settings);
    for (std::uint64_t pass = 0; pass < kPasses; ++pass) {
        const GatherRadii radii = adaptive.before_pass(photons_of(settings, pass), image);
        PhotonGrid grid;
        grid.build(quadratic_photons(kCurvature, kHalf, kPhotons, pass), radii.probe_radius);
        PhotonFlux flux;
        flux.wants_inner = true;
        flux.reset(image.visible_points.size(), 1, radii.probes.size());
        gather_probes(image, grid, radii, nullptr, flux.probes);
        adaptive.after_pass(flux);
    }
    const double area = 4 * kHalf * kHalf;
    const double density = 1 / (area * (1 + kCurvature * 2 * kHalf * kHalf / 3));
    const double value = 2 / std::numbers::pi;  // luminance of power times kd / pi
    const double laplacian = value * density * 4 * kCurvature;
    const double optimum = optimal_radius(value * value * density, laplacian * laplacian,
                                          double(kPhotons) * (kPasses + 1));
    const std::size_t middle = kSize / 2 * kSize + kSize / 2;
    EXPECT_NEAR(adaptive.before_pass(photons_of(settings, kPasses), image).of(middle) / optimum, 1,
                0.1);
}

/// Photons on the right half of a square alone, evenly.
std::vector<Photon> edge_photons(double half, int count, std::uint64_t seed) {
    std::vector<Photon> photons = quadratic_photons(0, half, count, seed);
    for (Photon& photon : photons)
        photon.position.x = std::abs(photon.position.x);
    return photons;
}

/// Radii of the pixels of a row across an edge of light, in pixels.
struct RowOfRadii {
    std::vector<double> narrowed, plain;
};

/// In each pass.
std::vector<RowOfRadii> radii_across_an_edge(std::size_t passes, int photons) {
    constexpr std::size_t kMiddle = std::size_t{kSize / 2} * kSize;
    const EyeImage image = plane_image();
    Settings settings = settings_with(std::uint32_t(photons));
    AdaptiveRadius narrowed = policy(settings);
    settings.narrow_radii = false;
    AdaptiveRadius plain = policy(settings);
    const auto run = [&](AdaptiveRadius& policy, std::uint64_t pass) {
        const GatherRadii radii = policy.before_pass(photons_of(settings, pass), image);
        PhotonGrid grid;
        grid.build(edge_photons(1.5, photons, pass), std::max(radii.probe_radius, radii.largest));
        PhotonFlux flux;
        flux.wants_inner = true;
        flux.reset(image.visible_points.size(), 1, radii.probes.size());
        InvalidSampleFilter filter;
        gather_photons(image, grid, radii, filter, flux);
        gather_probes(image, grid, radii, nullptr, flux.probes);
        policy.after_pass(flux);
        std::vector<double> row;
        for (std::size_t x = 0; x < kSize; ++x)
            row.push_back(double(radii.of(kMiddle + x)) / double(kPixel));
        return row;
    };
    std::vector<RowOfRadii> rows(passes);
    for (std::size_t pass = 0; pass < passes; ++pass)
        rows[pass] = {run(narrowed, pass), run(plain, pass)};
    return rows;
}

/// Where light ends the probes, which are wider than the discs, tell no curvature that would narrow
/// them enough: the dark pixel beside it, half a pixel away, takes light from across. Far from the
/// edge radii stay.
TEST(AdaptiveRadius, BlurNarrowsRadiiBesideAnEdge) {
    constexpr std::size_t kBeside = kSize / 2 - 1;
    const std::vector<RowOfRadii> rows = radii_across_an_edge(50, 60000);
    const RowOfRadii& after = rows[19];
    EXPECT_GT(after.plain[kBeside], 0.55);
    EXPECT_LT(after.narrowed[kBeside], 0.48) << "clear of the light";
    for (const std::size_t far : {0u, 1u, kSize - 2, kSize - 1})
        EXPECT_EQ(after.narrowed[far], after.plain[far]) << far;
    EXPECT_GT(rows.back().narrowed[kBeside], 0.25) << "and narrow no further";
}

TEST(AdaptiveRadius, ProbesTakeWhatTheGatherTakes) {
    EyeImage image = plane_image();
    const std::uint32_t only = 0;
    image.visible_points[0].position = {};
    image.visible_points[0].kd = {0, 1, 0};
    Photon above, below, dark;
    above.direction = above.normal = {0, 0, 1};
    above.power = {5, 1, 5};
    below = dark = above;
    below.direction = below.normal = {0, 0, -1};
    dark.power = {5, 0, 5};
    PhotonGrid grid;
    grid.build(std::vector<Photon>{above, below, dark}, 0.5f);
    GatherRadii radii(0.1f);
    radii.probes = {&only, 1};
    radii.probe_radius = 0.5f;
    std::vector<ProbeSums> sums(1);
    gather_probes(image, grid, radii, nullptr, sums);
    const double value = double(luminance(Rgb{0, 1, 0})) / std::numbers::pi;
    EXPECT_NEAR(sums[0].squares, value * value, 1e-6);
    for (const double curvature : sums[0].curvature)
        EXPECT_NEAR(curvature, -24 * value, 1e-5);
}

TEST(AdaptiveRadius, MemoryIsFlatAndWithinItsBound) {
    const EyeImage image = plane_image();
    const Settings settings = settings_with(1000);
    AdaptiveRadius adaptive = policy(settings);
    std::size_t bytes = 0;
    for (std::uint64_t pass = 0; pass < 40; ++pass) {
        adaptive.after_pass(flux_with(adaptive.before_pass(photons_of(settings, pass), image),
                                      probe_of(0.1, 3, 1)));
        if (pass == 16) bytes = adaptive.memory_bytes();
    }
    EXPECT_EQ(adaptive.memory_bytes(), bytes);
    constexpr std::size_t kPixels = std::size_t{kSize} * kSize;
    EXPECT_LE(bytes, AdaptiveRadius::memory_bound_bytes(kPixels, kPixels, true));
}

TEST(AdaptiveRadius, EngineStaysBelowItsBoundAndFlat) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 32, 24);
    mock::expect_flat_memory(scene, camera, 32, 24, settings_with(20000), 17);
}

/// Looks down on a floor, more and more past its edge as the shutter's time goes on: each pass, at
/// a time of its own, sees from all of its eye paths to none end on the floor.
class SwayingCamera final : public aips::Camera {
  public:
    explicit SwayingCamera(std::uint32_t size) : size_(size) {}
    CameraRay generate(const CameraSample& sample, float time) const override {
        const float past_the_edge = 2.2f * time;
        const mock::Camera camera({past_the_edge, 0, 1}, {0, 0, -1}, {0.9f, 0, 0}, {0, 0.9f, 0},
                                  size_, size_);
        return camera.generate(sample, time);
    }
    float shutter_open() const override { return 0; }
    float shutter_close() const override { return 1; }

  private:
    std::uint32_t size_;
};

TEST(AdaptiveRadius, MemoryIsBoundedWhenVisiblePointsComeAndGo) {
    mock::Scene scene;
    mock::Surface floor;
    floor.shape = mock::Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
    scene.add(floor);
    scene.add_point_light({0, 0, 2}, {1, 1, 1});
    scene.finish();
    const SwayingCamera camera(kSize);
    const mock::Sampler sampler(1);
    for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive}) {
        Settings settings = settings_with(4000);
        settings.direct_light_sampling = false;
        settings.guide = guide;
        mock::Film film(kSize, kSize);
        mock::Log log;
        Engine engine({scene, camera, sampler, film, log}, settings);
        std::size_t early = 0;
        unsigned blind = 0, part = 0;
        for (std::uint64_t pass = 0; pass < 80; ++pass) {
            const PassReport report = engine.render_pass(pass);
            const EngineStatistics now = engine.statistics();
            ASSERT_LE(now.memory_bytes, now.memory_bound_bytes) << "pass " << pass;
            ASSERT_TRUE(std::isfinite(report.radius)) << "pass " << pass;
            blind += report.photon_paths == 0;
            part += report.photon_paths > 0;
            if (pass == 49) early = now.memory_bytes;
        }
        EXPECT_GT(blind, 2u);  // passes without any visible point
        EXPECT_GT(part, 20u);
        EXPECT_LE(double(engine.statistics().memory_bytes), 1.02 * double(early));
        for (const Rgb& pixel : film.image())
            EXPECT_TRUE(is_valid_radiance(pixel));
    }
}

std::vector<Rgb> image_with(unsigned threads, GuideKind guide) {
    const mock::Scene scene = mock::lamp_box({}, mock::half_mirror());
    Settings settings = settings_with(20000);
    settings.guide = guide;
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 40, 30);
    return concurrency::run_on(
        threads, [&] { return mock::render(scene, camera, 40, 30, settings, 4).film.image(); });
}

TEST(AdaptiveRadius, SameBitsForAnyNumberOfThreads) {
    for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive}) {
        const auto one = image_with(1, guide);
        EXPECT_EQ(one, image_with(2, guide)) << mock::name(guide);
        EXPECT_EQ(one, image_with(7, guide)) << mock::name(guide);
    }
}

/// Modes with radii of their own take no notice.
TEST(AdaptiveRadius, FrozenModesKeepTheirRadii) {
    const mock::Scene scene = mock::lamp_box({}, {});
    for (const Mode mode : {Mode::PhotonMap, Mode::Ppm}) {
        Settings settings = settings_with(4000);
        settings.mode = mode;
        const auto asked = mock::radii(scene, settings, 3);
        settings.radius = RadiusKind::Schedule;
        EXPECT_EQ(asked, mock::radii(scene, settings, 3));
    }
}

/// An even field lets radii grow, and its image stays what it is.
TEST(AdaptiveRadius, KeepsTheMeanOfAFurnace) {
    mock::Scene scene;
    mock::Surface wall;
    wall.emitted = {1, 1, 1};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    scene.finish();
    Settings settings = settings_with(40000);
    settings.alpha = 1;
    settings.start_radius = 2;
    settings.max_photon_depth = 8;
    const auto camera = mock::camera_along_y({0, -0.5f, 0}, 0.4f, 32, 32);
    const double expected = 2 - 1.0 / 256;  // albedo 0.5, up to 8 scatterings
    for (const bool direct : {true, false}) {
        settings.direct_light_sampling = direct;
        const auto r = mock::render(scene, camera, 32, 32, settings, 20);
        EXPECT_NEAR(r.film.mean(), expected, 0.01 * expected);
        settings.radius = RadiusKind::Schedule;
        const float start = mock::render(scene, camera, 32, 32, settings, 1).statistics.radius;
        settings.radius = RadiusKind::Adaptive;
        EXPECT_GT(r.statistics.radius, 1.5f * start);
    }
}

/// Light and shadow of a whole scene: the difference from a render with a quarter of the radius is
/// mostly noise, and the mean agrees within 2 %.
TEST(AdaptiveRadius, ConvergesToTheFineRadius) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 24, 24);
    Settings settings = settings_with(40000);
    const auto adaptive = mock::render(scene, camera, 24, 24, settings, 30);
    settings.radius = RadiusKind::Schedule;
    settings.alpha = 1;
    settings.start_radius = 0.5;
    settings.seed = 2;
    const auto fine = mock::render(scene, camera, 24, 24, settings, 60);
    EXPECT_NEAR(adaptive.film.mean() / fine.film.mean(), 1, 0.02);
}

}  // namespace
}  // namespace aips::adaptive_radius_test
