// Facets with a grain: azimuths, and what they reflect at most.
#include "bsdfs/schlick_distribution.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "bsdf_statistics.h"
#include "shading_fixture.h"

namespace lxs::schlick_distribution_test {
namespace {

using shading::SchlickDistribution;

const std::array<Vec2, 6> kGrains{Vec2(0.02f, 0.3f), Vec2(0.1f, 0.9f),  Vec2(0.9f, 0.1f),
                                  Vec2(0.3f, 0.15f), Vec2(0.25f, 0.3f), Vec2(0.05f, 0.25f)};

double isotropy(const Vec2& roughness) {
    const double ratio = std::min(roughness.x, roughness.y) / std::max(roughness.x, roughness.y);
    return ratio * ratio;
}

/// Share of a right angle that `h` lies away from the axis of the larger roughness.
double turn(const Vec3& h, const Vec2& roughness) {
    const double x = std::abs(h.x), y = std::abs(h.y);
    return (roughness.x < roughness.y ? std::atan2(x, y) : std::atan2(y, x)) * 2 /
           3.141592653589793;
}

// 6 tests: 1 % for all of them together (Sidak).
constexpr double kSignificance = 1.7e-3;

TEST(SchlickDistribution, AzimuthsAreThoseThatLuxRenderDraws) {
    constexpr int kCells = 40, kSamples = 40000;
    std::uint32_t seed = 1;
    for (const Vec2& roughness : kGrains) {
        const SchlickDistribution facets(roughness.x, roughness.y);
        const double p2 = isotropy(roughness) * isotropy(roughness);
        UniformSource u(++seed);
        std::array<int, kCells> found{};
        for (int i = 0; i < kSamples; ++i) {
            const double t = turn(facets.sample(u.pair()), roughness);
            const double uniform = t / std::sqrt(p2 + t * t * (1 - p2));  // inverts the draw
            const int part = std::min(static_cast<int>(uniform * kCells), kCells - 1);
            ++found[static_cast<std::size_t>(part)];
        }
        double statistic = 0;
        for (const int n : found)
            statistic += std::pow(n - kSamples / kCells, 2) / (double{kSamples} / kCells);
        const boost::math::chi_squared law(kCells - 1);
        EXPECT_GT(cdf(complement(law, statistic)), kSignificance) << roughness;
    }
}

TEST(SchlickDistribution, AllQuadrantsAreDrawnAlike) {
    const SchlickDistribution facets(0.1f, 0.3f);
    UniformSource u(9);
    std::array<int, 4> found{};
    constexpr int kSamples = 40000;
    for (int i = 0; i < kSamples; ++i) {
        const Vec3 h = facets.sample(u.pair());
        ++found[(h.x > 0 ? 1u : 0u) + (h.y > 0 ? 2u : 0u)];
    }
    for (const int n : found)
        EXPECT_NEAR(n, kSamples / 4.0, 5 * std::sqrt(kSamples * 3 / 16.0));
}

TEST(SchlickDistribution, NormalsCoverTheSurfaceOnce) {
    for (const Vec2& roughness : kGrains) {
        const SchlickDistribution facets(roughness.x, roughness.y);
        const double r = double{roughness.x} * roughness.y;
        const double p2 = isotropy(roughness) * isotropy(roughness);
        constexpr int kSteps = 200;
        double sum = 0;
        for (int i = 0; i < kSteps; ++i) {
            // Cosines and turns where LuxRender would draw them.
            const double v = (i + 0.5) / kSteps, cos2 = v / (r * (1 - v) + v);
            for (int k = 0; k < kSteps; ++k) {
                const double w = (k + 0.5) / kSteps;
                const double t = std::sqrt(w * w * p2 / (1 - w * w * (1 - p2)));
                const double phi = t * 1.5707963267948966, s = std::sqrt(1 - cos2);
                const double along = s * std::cos(phi), across = s * std::sin(phi);
                const bool over_y = roughness.x < roughness.y;
                const Vec3 h(static_cast<float>(over_y ? across : along),
                             static_cast<float>(over_y ? along : across),
                             static_cast<float>(std::sqrt(cos2)));
                const double zenith = r / std::pow(cos2 * r + 1 - cos2, 2);
                const double azimuth = p2 / std::pow(p2 + t * t * (1 - p2), 1.5);
                sum += facets.density(h) * 3.141592653589793 / (zenith * azimuth);
            }
        }
        EXPECT_NEAR(sum / (kSteps * kSteps), 1, 2e-3) << roughness;
    }
}

TEST(SchlickDistribution, TheNormalItselfHasNoAzimuth) {
    for (const Vec2& roughness : kGrains) {
        const SchlickDistribution facets(roughness.x, roughness.y);
        const double expected = 1 / (3.141592653589793 * roughness.x * roughness.y);
        EXPECT_NEAR(facets.density(Vec3(0, 0, 1)) / expected, 1, 1e-5) << roughness;
    }
}

// However long the grain, and under any direction.
TEST(SchlickDistribution, GrainedIdealMetalReflectsAtMostWhatArrives) {
    ShadingFixture scene;
    BsdfMemory memory;
    for (const Vec2& roughness : kGrains) {
        const auto material = scene.make_material(
            "metal2", {number("fresnel", 4e3), number("uroughness", roughness.x),
                       number("vroughness", roughness.y)});
        const Bsdf& bsdf = *memory.scatter(*material, shading_point());
        for (const float degrees : {1.0f, 30.0f, 60.0f, 75.0f, 85.0f, 88.0f, 89.5f}) {
            for (const float azimuth : {0.0f, 0.3f, 0.8f, 1.4f, 1.5707963f}) {
                const float theta = degrees * 0.017453293f;
                const Vec3 wo(std::sin(theta) * std::cos(azimuth),
                              std::sin(theta) * std::sin(azimuth), std::cos(theta));
                const MeanWeight mean = mean_weight(bsdf, wo, Transport::Power, 4000, 5);
                EXPECT_LE(mean.mean.x, 1 + 5 * mean.deviation.x + 1e-4f)
                    << roughness << ' ' << degrees << ' ' << azimuth;
            }
        }
    }
}

}  // namespace
}  // namespace lxs::schlick_distribution_test
