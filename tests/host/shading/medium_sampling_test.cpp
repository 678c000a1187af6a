// Protects: free flights and directions in media are drawn with the densities that they are weighed
// by, and weights stay bounded where channels differ.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "bsdf_statistics.h"
#include "lxs/sdk/medium.h"

namespace lxs::medium_sampling_test {
namespace {

constexpr int kDraws = 200'000;

double integral_of_phase(const Medium& medium, int channel, double from, double to) {
    constexpr int kSteps = 20'000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = from + (to - from) * (i + 0.5) / kSteps;
        sum += medium.phase(static_cast<float>(cosine))[channel];
    }
    return 2 * M_PI * sum * (to - from) / kSteps;
}

/// The mean distance to a collision is 1 / extinction, and e^-(extinction * length) of all light
/// passes: z-tests at 5 standard errors.
TEST(MediumSampling, MeanFreePath) {
    const Medium grey({Rgb(0.5f), Rgb(1.5f), Rgb(0.0f)}, IndexCurve{});
    UniformSource random(1);
    double sum = 0, squares = 0;
    int passed = 0;
    for (int i = 0; i < kDraws; ++i) {
        const Flight endless =
            grey.sample_flight(std::numeric_limits<float>::infinity(), Rgb(1.0f), random.pair());
        ASSERT_TRUE(endless.collides);
        EXPECT_NEAR(endless.weight.x, 0.5, 1e-5);  // times scattering: the albedo
        sum += endless.distance;
        squares += double(endless.distance) * endless.distance;
        passed += grey.sample_flight(0.7f, Rgb(1.0f), random.pair()).collides ? 0 : 1;
    }
    const double mean = sum / kDraws;
    EXPECT_NEAR(mean, 0.5, 5 * std::sqrt((squares / kDraws - mean * mean) / kDraws));
    const double p = std::exp(-1.4);
    EXPECT_NEAR(double(passed) / kDraws, p, 5 * std::sqrt(p * (1 - p) / kDraws));
}

/// Each channel's own transmittance, and its integral over the segment, come out as means; no
/// weight exceeds what the whole path carries.
TEST(MediumSampling, ChannelsKeepTheirOwnExtinction) {
    const Rgb extinction(0.2f, 1.0f, 5.0f), carried(0.5f, 1.0f, 0.1f);
    const Medium medium({Rgb(0.0f), extinction, Rgb(0.0f)}, IndexCurve{});
    constexpr double kLength = 1.3;
    UniformSource random(2);
    Imath::V3d collided(0.0), passed(0.0), collided_squares(0.0), passed_squares(0.0);
    const float bound = 1.001f * (carried.x + carried.y + carried.z);
    for (int i = 0; i < kDraws; ++i) {
        const Flight flight = medium.sample_flight(float(kLength), carried, random.pair());
        const Rgb left = carried * flight.weight * (flight.collides ? extinction : Rgb(1.0f));
        ASSERT_LE(max_component(left), bound);
        const Imath::V3d weight(flight.weight.x, flight.weight.y, flight.weight.z);
        (flight.collides ? collided : passed) += weight;
        (flight.collides ? collided_squares : passed_squares) += weight * weight;
    }
    for (int c = 0; c < 3; ++c) {
        const auto check = [&](double sum, double squares, double expected) {
            const double mean = sum / kDraws;
            const double error = std::sqrt((squares / kDraws - mean * mean) / kDraws);
            EXPECT_NEAR(mean, expected, 5 * error) << "channel " << c;
        };
        const double share = std::exp(-double(extinction[c]) * kLength);
        check(passed[c], passed_squares[c], share);
        check(collided[c], collided_squares[c], (1 - share) / extinction[c]);
    }
}

TEST(MediumSampling, ClearChannelsPassForEver) {
    const Medium medium({Rgb(0, 0, 1), Rgb(0, 1, 0), Rgb(0.0f)}, IndexCurve{});
    UniformSource random(3);
    for (int i = 0; i < 1000; ++i) {
        const Flight flight =
            medium.sample_flight(std::numeric_limits<float>::infinity(), Rgb(1.0f), random.pair());
        EXPECT_TRUE(std::isfinite(flight.weight.x + flight.weight.y + flight.weight.z));
        EXPECT_GT(flight.collides ? flight.distance : flight.weight.x, 0);
    }
}

TEST(MediumSampling, PhaseIntegratesToOne) {
    const Medium medium({Rgb(0.0f), Rgb(1.0f), Rgb(0.7f, 0.0f, -0.9f)}, IndexCurve{});
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(integral_of_phase(medium, c, -1, 1), 1, 1e-3);
}

/// Cosines of drawn directions against phase_pdf: chi-square at 1e-4 each, and the mean cosine of
/// each channel by the weights.
TEST(MediumSampling, DirectionsFollowTheirDensity) {
    const Rgb carried(1.0f, 0.5f, 0.25f);
    const Vec3 direction = Vec3(0.3f, -0.5f, 0.8f).normalized();
    for (const Rgb& g : {Rgb(0.0f), Rgb(5e-4f), Rgb(0.8f), Rgb(-0.6f), Rgb(0.9f, 0.0f, -0.5f)}) {
        const Medium medium({Rgb(0.0f), Rgb(1.0f), g}, IndexCurve{});
        constexpr int kCells = 40;
        std::array<int, kCells> counts{};
        Imath::V3d cosines(0.0);
        UniformSource random(4);
        for (int i = 0; i < kDraws; ++i) {
            const PhaseSample sample = medium.sample_phase(direction, carried, random.pair());
            const float cosine = sample.direction.dot(direction);
            ASSERT_NEAR(sample.pdf, medium.phase_pdf(cosine, carried), 2e-3f * sample.pdf);
            ++counts[std::clamp(int((cosine + 1) / 2 * kCells), 0, kCells - 1)];
            for (int c = 0; c < 3; ++c)
                cosines[c] += double(sample.weight[c]) * cosine / kDraws;
        }
        double statistic = 0;
        for (int cell = 0; cell < kCells; ++cell) {
            double expected = 0;
            for (int c = 0; c < 3; ++c) {
                expected += kDraws * carried[c] / 1.75 *
                            integral_of_phase(medium, c, -1 + 2.0 * cell / kCells,
                                              -1 + 2.0 * (cell + 1) / kCells);
            }
            ASSERT_GT(expected, 5);
            statistic += (counts[cell] - expected) * (counts[cell] - expected) / expected;
        }
        const boost::math::chi_squared law(kCells - 1);
        EXPECT_GT(boost::math::cdf(boost::math::complement(law, statistic)), 1e-4) << g;
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(cosines[c], g[c], 0.02) << g;
    }
}

}  // namespace
}  // namespace lxs::medium_sampling_test
