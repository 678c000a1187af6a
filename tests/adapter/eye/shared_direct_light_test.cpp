// Protects what is learned of direct light where an eye path's BSDF-sampled ray shares it with
// shadow rays: both ways of reckoning it have one expectation, and near large lights sharing is
// calmer.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "aips/core/sampling/random.h"
#include "render_mock.h"
#include "traced_eye_image.h"

namespace aips::shared_direct_light_test {
namespace {

constexpr std::uint32_t kSize = 32, kPaths = 256 * kSize * kSize;
/// Beyond this a mean of differences is no chance: two-sided, significance 6e-5.
constexpr double kMostStandardErrors = 4;

struct Differences {
    double points = 0, alone = 0, sum = 0, squares = 0, alone_squares = 0, shared_squares = 0;

    explicit Differences(const EyeImage& image) {
        for (const VisiblePoint& point : image.visible_points) {
            if (!point.continued) continue;
            const double a = point.direct.alone, s = point.direct.shadow + point.direct.first;
            points += 1;
            alone += a;
            sum += a - s;
            squares += (a - s) * (a - s);
            alone_squares += a * a;
            shared_squares += s * s;
        }
    }
    double standard_error() const { return std::sqrt(squares); }
};

/// A closed box that shines, seen by eye paths of which one in four goes on.
EyeImage shining_box(const Vec3& eye) {
    mock::Scene scene;
    mock::Surface surface;
    surface.emitted = {1, 1, 1};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, surface);
    scene.finish();
    const EyeShares shares(scene.bounds());
    return mock::traced_eye_image(scene, mock::camera_along_y(eye, 0.4f, kSize, kSize), kSize,
                                  kPaths, mock::small_settings(5, 1), &shares);
}

TEST(SharedDirectLight, SameExpectation) {
    const Differences found(shining_box({0, -0.5f, 0}));
    ASSERT_NEAR(found.points, 0.25 * kPaths, 0.0025 * kPaths);
    EXPECT_NEAR(found.sum, 0, kMostStandardErrors * found.standard_error());
    EXPECT_GT(0.02 * found.alone, kMostStandardErrors * found.standard_error())
        << "a planted error of 2 % would go unnoticed";
}

/// The corner of a closed box that shines, with a veil in it that lets light through, seen by eye
/// paths that all do `eye`.
EyeImage veiled_corner(const EyeShare& eye, std::uint32_t max_photon_depth) {
    mock::Scene scene;
    mock::Surface wall, veil;
    wall.emitted = {1, 1, 1};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    veil.shape = mock::Ball{{0.3f, 0.3f, 0.3f}, 0.5f};
    veil.material.kind = mock::Material::Kind::Null;
    veil.material.reflectance = {0.9f, 0.9f, 0.9f};
    scene.add(veil);
    scene.finish();
    EyeShares shares(scene.bounds());
    shares.table.set_shares(std::vector<EyeShare>(shares.table.leaf_count(), eye));
    shares.any = eye.any();
    Settings settings = mock::small_settings(5, 1);
    settings.max_photon_depth = max_photon_depth;
    return mock::traced_eye_image(scene,
                                  mock::camera_along_y({0.7f, -0.5f, 0.7f}, 0.4f, kSize, kSize),
                                  kSize, kPaths, settings, &shares);
}

/// Of light at visible points.
struct Moments {
    double mean = 0, variance = 0, points = 0;

    explicit Moments(const EyeImage& image) : points(double(image.visible_points.size())) {
        double squares = 0;
        for (const VisiblePoint& point : image.visible_points) {
            const auto value = double(luminance(image.radiance[point.sample]));
            mean += value / points;
            squares += value * value / points;
        }
        variance = squares - mean * mean;
    }
};

void expect_same_direct_light(std::uint32_t max_photon_depth) {
    SCOPED_TRACE(max_photon_depth);
    const Moments a(veiled_corner({}, max_photon_depth));
    const Moments b(veiled_corner({.bsdf_direct = true}, max_photon_depth));
    // Stratified numbers only make the means better than this.
    const double error = std::sqrt((a.variance + b.variance) / a.points);
    EXPECT_NEAR(a.mean, b.mean, kMostStandardErrors * error);
    EXPECT_GT(0.02 * a.mean, kMostStandardErrors * error)
        << "a planted error of 2 % would go unnoticed";
    EXPECT_LT(b.variance, 0.8 * a.variance) << "BSDF-sampled rays make nothing calmer";
}

/// A veil has two sides: with a depth of 1 or 2 photons would get through no more than one.
TEST(SharedDirectLight, BsdfSampledDirectLightKeepsTheExpectation) {
    for (const std::uint32_t max_photon_depth : {1u, 2u, 8u})
        expect_same_direct_light(max_photon_depth);
}

TEST(SharedDirectLight, BsdfSampledDirectLightBringsNoOther) {
    const EyeImage image = veiled_corner({.bsdf_direct = true}, 8);
    std::size_t bsdf_direct = 0;
    for (const VisiblePoint& point : image.visible_points) {
        if (point.continued) continue;  // one in four explores
        ++bsdf_direct;
        ASSERT_LE(point.eye_rays, 3) << "to the veil, through it, and on to a wall";
        ASSERT_EQ(point.eye_share, 0);
        ASSERT_TRUE(is_black(image.continued[point.sample]));
    }
    EXPECT_GT(double(bsdf_direct), 0.7 * double(image.visible_points.size()));
}

TEST(SharedDirectLight, CalmerWhereLightIsNear) {
    const Differences found(shining_box({0.7f, -0.5f, 0.7f}));
    EXPECT_LT(found.shared_squares, 0.5 * found.alone_squares);
}

/// Two lights over eight directions, with sums in place of integrals: a sun that a bounce never
/// meets, and a sky in seven.
struct SunAndSky {
    static constexpr std::size_t kDirections = 8;
    std::array<double, 2> chosen{0.8, 0.2};
    std::array<double, kDirections> brought{3, 0.1, 0.4, 0.2, 0.9, 0.3, 0.05, 0.6};
    std::array<double, kDirections> asked{1, 0.4, 0.1, 0.1, 0.2, 0.1, 0.05, 0.05};
    std::array<double, kDirections> bounced{0, 0.05, 0.2, 0.1, 0.4, 0.1, 0.05, 0.1};

    static std::size_t light_of(std::size_t direction) { return direction == 0 ? 0 : 1; }
    double shadow_pdf(std::size_t i) const { return chosen[light_of(i)] * asked[i]; }

    /// By how much the variance for given lights falls.
    double saved(double end_pdf) const {
        double squares = 0, first = 0;
        std::array<double, 2> all{}, kept{};
        for (std::size_t i = 0; i < kDirections; ++i) {
            const double g = brought[i],
                         part = g * shadow_pdf(i) / (shadow_pdf(i) + end_pdf * bounced[i]);
            squares += g * (g - part) / shadow_pdf(i);
            all[light_of(i)] += g;
            kept[light_of(i)] += part;
            first += g - part;
        }
        for (const std::size_t l : {std::size_t{0}, std::size_t{1}})
            squares -= (all[l] * all[l] - kept[l] * kept[l]) / chosen[l];
        return squares + first * first;
    }

    static std::size_t drawn(const std::array<double, kDirections>& pdf, std::size_t first,
                             double u) {
        std::size_t i = first;
        while (i + 1 < kDirections && u >= pdf[i])
            u -= pdf[i++];
        return i;
    }

    SharedDirect sample(RandomStream& random, double end_pdf) const {
        const std::size_t light = random.next() < float(chosen[0]) ? 0 : 1;
        const std::size_t i = light == 0 ? 0 : drawn(asked, 1, double(random.next()));
        const std::size_t k = drawn(bounced, 1, double(random.next()));
        const auto weight = [&](std::size_t j) {
            return shadow_pdf(j) / (shadow_pdf(j) + end_pdf * bounced[j]);
        };
        SharedDirect s;
        s.alone = float(brought[i] / shadow_pdf(i));
        s.shadow = s.alone * float(weight(i));
        s.first = float(brought[k] * (1 - weight(k)) / (bounced[k] * end_pdf));
        s.asked_again = light == 1 ? s.first / float(chosen[1]) : 0;
        s.end_pdf = float(end_pdf);
        return s;
    }
};

TEST(SharedDirectLight, TellsTheVarianceForGivenLights) {
    constexpr int kSamples = 400000;
    const SunAndSky scene;
    for (const double end_pdf : {1.0, 0.3}) {
        RandomStream random(11, std::uint64_t(end_pdf * 10), 0, RandomDomain::Eye);
        double sum = 0, squares = 0, planted = 0;
        for (int n = 0; n < kSamples; ++n) {
            SharedDirect s = scene.sample(random, end_pdf);
            const double saved = double(s.taken()) - double(s.added());
            sum += saved / kSamples;
            squares += saved * saved / kSamples;
            s.asked_again = s.first;  // forgets how seldom the light is asked
            planted += (double(s.taken()) - double(s.added())) / kSamples;
        }
        const double error = std::sqrt((squares - sum * sum) / kSamples);
        EXPECT_NEAR(sum, scene.saved(end_pdf), kMostStandardErrors * error);
        EXPECT_GT(std::abs(planted - scene.saved(end_pdf)), 3 * kMostStandardErrors * error)
            << "a planted error would go unnoticed";
    }
}

}  // namespace
}  // namespace aips::shared_direct_light_test
