// Protects the adaptive radius's formulas: probes find the curvature and the noise of a known
// density, and the radius chosen has less measured error than its neighbours.
#include "aips/core/radii/optimal_radius.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "aips/core/sampling/random.h"

namespace aips::optimal_radius_test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Photons of paths that land once each, with density (1 + k (x^2 + y^2) + x / 2) / integral over
/// the square [-1, 1]^2: curved, with a slope that must not matter.
struct Quadratic {
    double k = 3;
    double integral() const { return 4 + k * 8 / 3; }
    double laplacian() const { return 4 * k / integral(); }
    double at_centre() const { return 1 / integral(); }

    struct Photon {
        double squared_distance, value;
    };
    /// Values are 1 or 3, each with probability 1/2: mean 2, mean square 5.
    Photon sample(RandomStream& random) const {
        const double greatest = 1.5 + 2 * k;
        for (;;) {
            const double x = 2 * double(random.next()) - 1, y = 2 * double(random.next()) - 1;
            const double squared = x * x + y * y;
            if (double(random.next()) * greatest < 1 + k * squared + x / 2) {
                return {squared, random.next() < 0.5f ? 1.0 : 3.0};
            }
        }
    }
};

ProbeEstimate probe(const Quadratic& density, double radius, int paths, std::uint64_t seed) {
    RandomStream random(seed, 0, 0, RandomDomain::Photon);
    ProbeSums sums;
    for (int i = 0; i < paths; ++i) {
        const auto photon = density.sample(random);
        const double share = photon.squared_distance / (radius * radius);
        if (share <= 1) sums.add(photon.value, share);
    }
    return probe_estimate(sums, radius, paths);
}

/// Over a disc: mean weight 0, mean of weight times share 4. And nothing of the square it knows
/// not.
TEST(OptimalRadius, CurvatureWeightIsExactForQuadratics) {
    double even = 0, curved = 0;
    constexpr int kSteps = 1000;
    for (int i = 0; i < kSteps; ++i) {
        const double share = (i + 0.5) / kSteps;
        even += curvature_weight(share) / kSteps;
        curved += curvature_weight(share) * share / 4 / kSteps;
    }
    EXPECT_NEAR(even, 0, 1e-9);
    EXPECT_NEAR(curved, 1, 1e-5);
}

/// z-tests at 4 sigma (6e-5 two-sided) of 400 probes, and the error that probes state themselves.
TEST(OptimalRadius, ProbesFindAKnownQuadraticDensity) {
    const Quadratic density;
    constexpr int kProbes = 400, kPaths = 2000;
    constexpr double kRadius = 0.8;
    struct {
        double mean = 0, squares = 0, stated = 0;
    } laplacian[kProbeScales];
    double moment = 0, moment_squares = 0;
    for (int i = 0; i < kProbes; ++i) {
        const ProbeEstimate e = probe(density, kRadius, kPaths, std::uint64_t(i) + 1);
        for (std::size_t scale = 0; scale < kProbeScales; ++scale) {
            const auto [value, error2] = e.laplacian[scale];
            laplacian[scale].mean += value / kProbes;
            laplacian[scale].squares += value * value / kProbes;
            laplacian[scale].stated += error2 / kProbes;
        }
        moment += e.second_moment / kProbes;
        moment_squares += e.second_moment * e.second_moment / kProbes;
    }
    for (const auto& l : laplacian) {
        const double variance = l.squares - l.mean * l.mean;
        EXPECT_NEAR(l.mean, 2 * density.laplacian(), 4 * std::sqrt(variance / kProbes));
        // The relative variance of a variance of 400 nearly normal numbers is 2 / 400.
        EXPECT_NEAR(l.stated / variance, 1, 4 * std::sqrt(2.0 / kProbes));
    }
    // The second moment's own mean over the disc is off by r^2 / 8 Laplacian.
    const double expected = 5 * (density.at_centre() + kRadius * kRadius / 8 * density.laplacian());
    const double moment_variance = moment_squares - moment * moment;
    EXPECT_NEAR(moment, expected, 4 * std::sqrt(moment_variance / kProbes));
}

/// Mean squared error at the centre of the mean over 8 passes whose radii are `factor` times those
/// of optimal_radius.
double measured_error(const Quadratic& density, double factor) {
    constexpr int kRepeats = 500, kPasses = 6, kPaths = 500;
    const double q = 5 * density.at_centre(), laplacian = 2 * density.laplacian();
    double error = 0;
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        RandomStream random(7, std::uint64_t(repeat), 0, RandomDomain::Photon);
        double image = 0;
        for (int pass = 1; pass <= kPasses; ++pass) {
            const double radius =
                factor * optimal_radius(q, laplacian * laplacian, double(kPaths) * pass);
            double sum = 0;
            for (int i = 0; i < kPaths; ++i) {
                const auto photon = density.sample(random);
                if (photon.squared_distance <= radius * radius) sum += photon.value;
            }
            image += sum / (kPi * radius * radius * kPaths) / kPasses;
        }
        const double off = image - 2 * density.at_centre();
        error += off * off / kRepeats;
    }
    return error;
}

/// In theory the errors are as f^4 / 3 + 2 / (3 f^2): 1, 1.62 (f = 1.4) and 1.44 (f = 0.7); a mean
/// of 500 squares is good to 6 %.
TEST(OptimalRadius, HasLessMeasuredErrorThanItsNeighbours) {
    const Quadratic density;
    const double best = measured_error(density, 1);
    EXPECT_NEAR(measured_error(density, 1.4) / best, 1.62, 0.4);
    EXPECT_NEAR(measured_error(density, 0.7) / best, 1.44, 0.4);
}

/// What is expected of a squared Laplacian: its square and its error. Narrow discs count if they
/// are sure of more.
TEST(OptimalRadius, NarrowDiscsTakeOverWhereTheyAreSure) {
    ProbeEstimate e;
    e.laplacian[0] = {2, 1};
    EXPECT_DOUBLE_EQ(expected_squared_laplacian(e), 5);
    e.laplacian[2] = {10, 36};  // less than two standard errors: chance
    EXPECT_DOUBLE_EQ(expected_squared_laplacian(e), 5);
    e.laplacian[2] = {-10, 4};
    EXPECT_DOUBLE_EQ(expected_squared_laplacian(e), 100 - 4 * 4);
    e.laplacian[1] = {-10, 1};
    EXPECT_DOUBLE_EQ(expected_squared_laplacian(e), 100 - 4);
}

/// Noise asks for more, curvature for less; units of light do not matter, units of length scale it.
TEST(OptimalRadius, Scales) {
    const double r = optimal_radius(2, 3, 1000);
    EXPECT_DOUBLE_EQ(optimal_radius(2, 3, 64000), r / 2);
    EXPECT_DOUBLE_EQ(optimal_radius(2e20, 3e20, 1000), r);
    // Lengths doubled: a density of squares is a quarter, a Laplacian of a density a 16th.
    EXPECT_DOUBLE_EQ(optimal_radius(2.0 / 4, 3.0 / 256, 1000), 2 * r);
}

TEST(OptimalRadius, SumsScaleLikeTheirValues) {
    ProbeSums one, two;
    for (const double share : {0.1, 0.5, 0.9}) {
        one.add(2 + share, share);
        two.add(3 * (2 + share), share);
    }
    one.scale(3);
    EXPECT_DOUBLE_EQ(one.squares, two.squares);
    for (std::size_t scale = 0; scale < kProbeScales; ++scale) {
        EXPECT_NEAR(one.curvature[scale], two.curvature[scale], 1e-9);
        EXPECT_NEAR(one.uncertainty[scale], two.uncertainty[scale], 1e-9);
    }
}

}  // namespace
}  // namespace aips::optimal_radius_test
