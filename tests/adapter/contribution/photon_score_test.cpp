// Protects the score of photons: the squared contribution per visible point, whatever the radius
// and the number of visible points.
#include "contribution/photon_score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "aips/core/sampling/random.h"
#include "aips/core/sampling/sampling.h"
#include "mock_bsdf.h"

namespace aips::photon_score_test {
namespace {

constexpr Vec3 kUp{0, 0, 1};

VisiblePoint point_at(Vec3 position) {
    VisiblePoint point;
    point.position = position;
    point.geometric_normal = point.shading_normal = point.wo = kUp;
    point.throughput = {0.5f, 0.25f, 1};
    point.kd = {0.3f, 0.6f, 0.9f};
    point.receiving = kDiffuse;
    return point;
}

Photon photon_at(Vec3 position, Rgb power = {1, 2, 3}) {
    Photon photon;
    photon.position = position;
    photon.direction = photon.normal = kUp;
    photon.power = power;
    return photon;
}

/// Score among these visible points, the weight of each being `weight`.
double score(const std::vector<VisiblePoint>& points, const GatherRadii& radii,
             const Photon& photon, float weight = 1) {
    EyeImage image;
    image.visible_points = points;
    std::vector<Vec3> positions;
    positions_of(points, positions);
    const std::vector<float> weights(points.size(), weight);
    PhotonScore scores;
    scores.build(image, positions, radii, weights);
    return scores.score(photon);
}

/// Luminance that a photon of power `p` adds to point_at() times the disc's area.
double value_of(Rgb p) {
    const VisiblePoint v = point_at({});
    return double(luminance(v.throughput * v.kd * p)) / double(kPi);
}

TEST(PhotonScore, ClosedFormForOnePointAndOnePhoton) {
    constexpr double kRadius = 0.2, kWeight = 7;
    const double expected =
        kWeight * std::pow(value_of({1, 2, 3}), 2) / (double(kPi) * kRadius * kRadius);
    const Photon photon = photon_at({0.1f, 0, 0});
    EXPECT_NEAR(score({point_at({})}, float(kRadius), photon, float(kWeight)), expected,
                1e-5 * expected);
    // Three points, one of them elsewhere.
    const std::vector<VisiblePoint> three{point_at({}), point_at({5, 0, 0}), point_at({})};
    EXPECT_NEAR(score(three, float(kRadius), photon, float(kWeight)), expected * 2 / 3,
                1e-5 * expected);
    // The same surface by a Bsdf of its own.
    Arena arena;
    mock::Material material;
    material.reflectance = point_at({}).kd;
    VisiblePoint with_bsdf = point_at({});
    with_bsdf.bsdf = mock::make_bsdf(material, kUp, kUp, arena);
    with_bsdf.kd = {};
    EXPECT_NEAR(score({with_bsdf}, float(kRadius), photon, float(kWeight)), expected,
                1e-5 * expected);
}

TEST(PhotonScore, EachPointHasItsOwnWeightAndRadius) {
    EyeImage image;
    image.visible_points = {point_at({}), point_at({0.01f, 0, 0}), point_at({0.02f, 0, 0})};
    const std::vector<Vec3> positions{{}, {0.01f, 0, 0}, {0.02f, 0, 0}};
    const std::vector<float> weights{1, 10, 100};
    const std::vector<float> own{0.1f, 0.2f, 0.05f};
    GatherRadii radii(0.2f);
    radii.per_point = own;
    PhotonScore scores;
    scores.build(image, positions, radii, weights);
    const double value = std::pow(value_of({1, 2, 3}), 2) / double(kPi) / 3;
    const double expected = value * (1 / 0.01 + 10 / 0.04);  // the third one's disc ends at 0.07
    EXPECT_NEAR(scores.score(photon_at({0.08f, 0, 0})), expected, 1e-4 * expected);
}

TEST(PhotonScore, GrowsWithTheSquareOfThePower) {
    const std::vector<VisiblePoint> points{point_at({}), point_at({0.02f, 0, 0})};
    const double one = score(points, 0.1f, photon_at({}, {1, 2, 3}));
    EXPECT_GT(one, 0);
    EXPECT_NEAR(score(points, 0.1f, photon_at({}, {3, 6, 9})), 9 * one, 1e-5 * one);
}

TEST(PhotonScore, ZeroWhereNothingIsContributed) {
    const std::vector<VisiblePoint> points{point_at({})};
    ASSERT_GT(score(points, 0.1f, photon_at({0.09f, 0, 0})), 0);
    EXPECT_EQ(score(points, 0.1f, photon_at({0.11f, 0, 0})), 0);
    EXPECT_EQ(score({}, 0.1f, photon_at({})), 0);
    EXPECT_EQ(score(points, 0.1f, photon_at({}, {})), 0);
    Photon behind = photon_at({});
    behind.direction = -kUp;
    EXPECT_EQ(score(points, 0.1f, behind), 0);
    Photon on_a_wall = photon_at({});
    on_a_wall.normal = {1, 0, 0};
    EXPECT_EQ(score(points, 0.1f, on_a_wall), 0);
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        EXPECT_EQ(score(points, 0.1f, photon_at({}, {bad, 1, 1})), 0);
}

/// Visible points lie evenly in a square of side 1: in expectation the score is the value's square
/// by the square's area. Discs hold binomial numbers of points, which gives the standard error;
/// 4 of them (p < 1e-4).
void expect_mean_score(unsigned points, double radius) {
    constexpr int kRuns = 200;
    const double expected = std::pow(value_of({1, 2, 3}), 2);
    double mean = 0;
    for (int run = 0; run < kRuns; ++run) {
        RandomStream random(points, std::uint64_t(run), std::uint64_t(radius * 1000),
                            RandomDomain::Guide);
        std::vector<VisiblePoint> all;
        for (unsigned i = 0; i < points; ++i)
            all.push_back(point_at({random.next() - 0.5f, random.next() - 0.5f, 0}));
        mean += score(all, float(radius), photon_at({})) / kRuns;
    }
    const double inside = double(kPi) * radius * radius;
    const double error = expected * std::sqrt((1 - inside) / (inside * points * kRuns));
    ASSERT_LT(error, 0.1 * expected);
    EXPECT_NEAR(mean, expected, 4 * error) << points << " points, radius " << radius;
}

TEST(PhotonScore, ExpectationDoesNotDependOnTheRadius) {
    for (const double radius : {0.03, 0.1, 0.3})
        expect_mean_score(1000, radius);
}

TEST(PhotonScore, ExpectationDoesNotDependOnTheNumberOfVisiblePoints) {
    for (const unsigned points : {50u, 500u, 5000u})
        expect_mean_score(points, 0.15);
}

}  // namespace
}  // namespace aips::photon_score_test
