// Protects eq. 2, 3, 4 and 8: closed forms on hand-made nodes, and finite results on bad ones.
#include "aips/core/trees/error_criterion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "aips/core/sampling/random.h"

namespace aips::error_criterion_test {
namespace {

constexpr double kPi64 = std::numbers::pi;

ValueStatistics statistics_of(std::span<const NodePhoton> photons) {
    ValueStatistics s;
    for (const NodePhoton& p : photons)
        s.add(double(p.value));
    return s;
}

TEST(Triweight, IntegratesToOneWithItsSecondMomentAndAFlatLaplacian) {
    constexpr int kSteps = 200000;
    double mass = 0, moment = 0, laplacian = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double s = (i + 0.5) / kSteps;
        const double ring = 2 * kPi64 * s / kSteps;
        mass += triweight(s) * ring;
        moment += 0.5 * s * s * triweight(s) * ring;  // x^2 is half of s^2 around the ring
        laplacian += triweight_laplacian(s) * ring;
    }
    EXPECT_NEAR(mass, 1, 1e-8);
    EXPECT_NEAR(moment, kTriweightSecondMoment, 1e-8);
    EXPECT_NEAR(laplacian, 0, 1e-8);
    EXPECT_EQ(triweight(1), 0);
    EXPECT_EQ(triweight_laplacian(1.5), 0);
}

TEST(Triweight, LaplacianIsThatOfTheKernel) {
    constexpr double kStep = 1e-4;
    for (double s = 0.05; s < 0.95; s += 0.05) {
        const double second =
            (triweight(s + kStep) - 2 * triweight(s) + triweight(s - kStep)) / (kStep * kStep);
        const double first = (triweight(s + kStep) - triweight(s - kStep)) / (2 * kStep);
        EXPECT_NEAR(triweight_laplacian(s), second + first / s, 1e-4);
    }
}

// Two photons at the ends of a square's diagonal, one in the middle: only the middle one is under
// the kernel, so B = pi k2 / 2 * lap K(0) * power.
TEST(BiasCorrection, ClosedFormForOnePhotonUnderTheKernel) {
    const std::vector<NodePhoton> photons{{{0, 0, 5}, 9}, {{2, 2, 5}, 9}, {{1, 1, 5}, 3}};
    const double laplacian = -12 * 4 / kPi64;
    EXPECT_NEAR(bias_correction(photons), kPi64 * 0.1 / 2 * laplacian * 3, 1e-9);
}

TEST(BiasCorrection, DoesNotDependOnScaleOrPlace) {
    RandomStream random(1, 0, 0, RandomDomain::Guide);
    std::vector<NodePhoton> photons, moved;
    for (int i = 0; i < 64; ++i) {
        const Vec2 u = random.next2();
        const float power = random.next();
        photons.push_back({{u.x, u.y, 0}, power});
        moved.push_back({{8 * u.x + 16, 3, 8 * u.y - 32}, power});
    }
    EXPECT_NEAR(bias_correction(photons), bias_correction(moved), 1e-4);
}

// An even density has no bias, a peak has a negative one, a hollow a positive one.
TEST(BiasCorrection, SeesPeaksAndHollows) {
    std::vector<NodePhoton> even, peak, hollow;
    for (int x = 0; x <= 60; ++x) {
        for (int y = 0; y <= 60; ++y) {
            const Vec3 p{float(x), float(y), 0};
            const float distance = std::hypot(float(x - 30), float(y - 30)) / 30;
            even.push_back({p, 1});
            peak.push_back({p, std::max(0.0f, 1 - distance)});
            hollow.push_back({p, distance});
        }
    }
    EXPECT_NEAR(bias_correction(even), 0, 0.01);
    EXPECT_LT(bias_correction(peak), -0.05);
    EXPECT_GT(bias_correction(hollow), 0.05);
}

TEST(BiasCorrection, NoneWithoutAnArea) {
    EXPECT_EQ(bias_correction({}), 0);
    EXPECT_EQ(bias_correction(std::vector<NodePhoton>(5, NodePhoton{{1, 2, 3}, 4})), 0);
    const std::vector<NodePhoton> line{{{0, 0, 0}, 1}, {{1, 0, 0}, 2}, {{2, 0, 0}, 3}};
    EXPECT_EQ(bias_correction(line), 0);
}

// Eq. 4 summed as printed (from j = 1) against the running form.
TEST(CorrectedVariance, IsEquation4) {
    const std::vector<NodePhoton> photons{{{}, 1}, {{}, 4}, {{}, 7}, {{}, 2}};
    const double bias = 0.75, mean = 3.5;
    double sum = 0;
    for (const NodePhoton& p : photons)
        sum += std::pow(double(p.value) - mean + bias, 2);
    EXPECT_NEAR(corrected_variance(statistics_of(photons), bias), sum / 3, 1e-12);
}

TEST(NodeError, IsEquation2AndFinite) {
    EXPECT_DOUBLE_EQ(node_error(0.5, 3, 4, 6), 1);
    EXPECT_EQ(node_error(0, 3, 4, 6), 0);
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(std::isfinite(node_error(1e300, 1e300, 1, 1)));
    EXPECT_EQ(node_error(0, inf, 1, 1), 0);
    EXPECT_EQ(node_error(-1, 1, 1, 1), 0);
}

class PaperCriterion : public testing::Test {
  protected:
    PaperCriterion() {
        node.weight = 2;
        for (const NodePhoton& p : photons)
            node.values.add(double(p.value));
    }
    std::vector<NodePhoton> photons{{{0, 0, 0}, 1}, {{1, 0, 0}, 3}};  // variance 2, no area
    Node node;
};

TEST_F(PaperCriterion, FirstPassIsEquation2) {
    EXPECT_DOUBLE_EQ(PaperErrorCriterion(0.4).error({node, photons, 5}), 2 * 2 * 5 / 2.0);
}

TEST_F(PaperCriterion, LaterPassesMixInTheLastError) {
    node.has_last_error = true;
    node.last_error = 100;
    node.error = 7;  // of an earlier iteration of this pass: without influence
    EXPECT_DOUBLE_EQ(PaperErrorCriterion(0.4).error({node, photons, 5}), 0.6 * 10 + 0.4 * 100);
    EXPECT_DOUBLE_EQ(PaperErrorCriterion(0).error({node, photons, 5}), 10);
}

TEST_F(PaperCriterion, FewerThanTwoPhotonsKeepTheError) {
    node.values = {};
    node.values.add(4);
    node.error = 3.25;
    EXPECT_EQ(PaperErrorCriterion().error({node, photons, 5}), 3.25);
}

TEST_F(PaperCriterion, ExtremePowersStayFinite) {
    for (const float power : {3e38f, 1e-45f, 0.0f}) {
        Node extreme;
        extreme.weight = 1e10;
        std::vector<NodePhoton> many;
        for (int i = 0; i < 32; ++i) {
            const int x = i % 6, y = i / 6;
            many.push_back({{float(x), float(y), 0}, i % 2 ? power : 0.0f});
            extreme.values.add(double(many.back().value));
        }
        const double error = PaperErrorCriterion().error({extreme, many, 1e100});
        EXPECT_TRUE(std::isfinite(error) && error >= 0);
    }
}

TEST(ImageCriterion, ErrorIsTheRootOfTheMeanScoreOfUnitPower) {
    const ImageErrorCriterion criterion(0.4);
    EXPECT_TRUE(criterion.needs_scores());
    Node node;
    const double scores[] = {16, 0, 100};
    const float powers[] = {2, 3, 5};  // of unit power: 4, 0, 4
    for (int i = 0; i < 3; ++i)
        node.values.add(double(criterion.value(powers[i], scores[i])));
    const double root_mean_square = std::sqrt(8.0 / 3);
    EXPECT_DOUBLE_EQ(criterion.error({node, {}, 5}), root_mean_square);
    node.has_last_error = true;
    node.last_error = 10;
    EXPECT_DOUBLE_EQ(criterion.error({node, {}, 5}), 0.6 * root_mean_square + 4);
}

TEST(ImageCriterion, AsksNothingOfPowersThatTellNothing) {
    const ImageErrorCriterion criterion;
    EXPECT_EQ(criterion.value(0, 1), 0);
    EXPECT_EQ(criterion.value(1, 0), 0);
    EXPECT_EQ(criterion.value(std::nanf(""), 1), 0);
    EXPECT_EQ(criterion.value(1, std::nan("")), 0);
}

TEST_F(PaperCriterion, RefusesAlphaOutOfRange) {
    EXPECT_THROW(PaperErrorCriterion(1.0), std::invalid_argument);
    EXPECT_THROW(PaperErrorCriterion(-0.1), std::invalid_argument);
    EXPECT_THROW(PaperErrorCriterion(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace aips::error_criterion_test
