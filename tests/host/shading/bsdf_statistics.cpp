// Statistical comparisons of a Bsdf's sampling with its density and values.
#include "bsdf_statistics.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <vector>

#include "lxs/sdk/frame.h"
#include "lxs/sdk/warp.h"

namespace lxs {
namespace {

constexpr int kCosines = 24, kAngles = 36;

Vec3 cell_direction(const Frame& frame, double cosine_step, double angle_step) {
    const double z = 2 * cosine_step / kCosines - 1;
    const double r = std::sqrt(std::max(0.0, 1 - z * z)), phi = 2 * kPi * angle_step / kAngles;
    return frame.to_world(Vec3(static_cast<float>(r * std::cos(phi)),
                               static_cast<float>(r * std::sin(phi)), static_cast<float>(z)));
}

int cell_of(const Frame& frame, const Vec3& direction) {
    const Vec3 local = frame.to_local(direction);
    double phi = std::atan2(local.y, local.x);
    if (phi < 0) phi += 2 * kPi;
    const int i = std::clamp(static_cast<int>((local.z + 1) * 0.5 * kCosines), 0, kCosines - 1);
    const int j = std::clamp(static_cast<int>(phi / (2 * kPi) * kAngles), 0, kAngles - 1);
    return i * kAngles + j;
}

/// Probability of each cell by the midpoint rule.
std::vector<double> expected_shares(const Bsdf& bsdf, const Vec3& wo, const Frame& frame,
                                    LobeMask mask) {
    constexpr int kSteps = 24;
    std::vector<double> shares(std::size_t{kCosines} * kAngles);
    for (int cell = 0; cell < kCosines * kAngles; ++cell) {
        const int row = cell / kAngles, column = cell % kAngles;
        for (int k = 0; k < kSteps * kSteps; ++k) {
            const int y = k / kSteps, x = k % kSteps;
            const double i = row + (y + 0.5) / kSteps, j = column + (x + 0.5) / kSteps;
            shares[cell] += bsdf.pdf(wo, cell_direction(frame, i, j), mask);
        }
        shares[cell] *= 4 * kPi / (kCosines * kAngles) / (kSteps * kSteps);
    }
    return shares;
}

double pooled_p_value(const std::vector<double>& expected, const std::vector<double>& found) {
    constexpr double kLeast = 5;
    double statistic = 0, pooled_expected = 0, pooled_found = 0;
    int cells = 0;
    const auto add = [&](double e, double f) {
        statistic += (f - e) * (f - e) / e;
        ++cells;
    };
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] >= kLeast) {
            add(expected[i], found[i]);
        } else {
            pooled_expected += expected[i];
            pooled_found += found[i];
        }
    }
    if (pooled_expected >= kLeast) add(pooled_expected, pooled_found);
    // Samples where none can be are no matter of chance.
    else if (pooled_found > pooled_expected + 6 * std::sqrt(pooled_expected) + 6)
        return 0;
    if (cells < 2) return 1;
    return cdf(complement(boost::math::chi_squared(cells - 1), statistic));
}

}  // namespace

Vec3 UniformSource::direction() {
    const float z = 1 - 2 * (*this)(), phi = 2 * kPi * (*this)();
    const float r = std::sqrt(std::max(0.0f, 1 - z * z));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

double chi_square_p_value(const Bsdf& bsdf, const Vec3& wo, const Vec3& axis, LobeMask mask,
                          std::uint32_t seed) {
    constexpr int kSamples = 60000;
    const Frame frame(axis);
    std::vector<double> expected = expected_shares(bsdf, wo, frame, mask);
    std::vector<double> found(expected.size() + 1);
    double sum = 0;
    for (double& e : expected) {
        sum += e;
        e *= kSamples;
    }
    expected.push_back(std::max(0.0, 1 - sum) * kSamples);
    UniformSource u(seed);
    for (int i = 0; i < kSamples; ++i) {
        BsdfSample sample;
        const Vec2 uv = u.pair();
        const bool scattered =
            bsdf.sample(wo, uv, u(), Transport::Radiance, mask, sample) && sample.lobe != kSpecular;
        ++found[scattered ? cell_of(frame, sample.wi) : expected.size() - 1];
    }
    return pooled_p_value(expected, found);
}

MeanWeight mean_weight(const Bsdf& bsdf, const Vec3& wo, Transport transport, int samples,
                       std::uint32_t seed) {
    UniformSource u(seed);
    double sum[3] = {}, squares[3] = {};
    for (int i = 0; i < samples; ++i) {
        BsdfSample sample;
        const Vec2 uv = u.pair();
        if (!bsdf.sample(wo, uv, u(), transport, kAllLobes, sample)) continue;
        for (int c = 0; c < 3; ++c) {
            sum[c] += sample.weight[c];
            squares[c] += double{sample.weight[c]} * sample.weight[c];
        }
    }
    MeanWeight result;
    for (int c = 0; c < 3; ++c) {
        const double mean = sum[c] / samples;
        const double variance = std::max(0.0, squares[c] / samples - mean * mean);
        result.mean[c] = static_cast<float>(mean);
        result.deviation[c] = static_cast<float>(std::sqrt(variance / samples));
    }
    return result;
}

Rgb integrated_albedo(const Bsdf& bsdf, const Vec3& wo, const Vec3& ns) {
    constexpr int kZ = 400, kPhi = 400;
    const Frame frame(ns);
    double sum[3] = {};
    for (int i = 0; i < kZ; ++i) {
        // Cosines as squares put more points where f changes fastest.
        const double x = (i + 0.5) / kZ * 2 - 1, z = x * std::abs(x);
        for (int j = 0; j < kPhi; ++j) {
            const double phi = 2 * kPi * (j + 0.5) / kPhi, r = std::sqrt(1 - z * z);
            const Vec3 wi =
                frame.to_world(Vec3(static_cast<float>(r * std::cos(phi)),
                                    static_cast<float>(r * std::sin(phi)), static_cast<float>(z)));
            const Rgb f = bsdf.evaluate(wo, wi, Transport::Radiance, kAllLobes);
            for (int c = 0; c < 3; ++c)
                sum[c] += f[c] * std::abs(z) * 2 * std::abs(x);
        }
    }
    const double scale = 2.0 / kZ * 2 * kPi / kPhi;
    return {static_cast<float>(sum[0] * scale), static_cast<float>(sum[1] * scale),
            static_cast<float>(sum[2] * scale)};
}

}  // namespace lxs
