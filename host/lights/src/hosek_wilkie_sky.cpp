// Radiance of the clear sky (Hosek & Wilkie 2012).
#include "hosek_wilkie_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lxs/spectrum/colour_matching.h"

namespace lxs {
namespace {

constexpr int kControlPoints = HosekWilkieChannel::kControlPoints;
using Weights = std::array<double, kControlPoints>;

/// Bernstein polynomials of degree 5 at x (section 5.2: x is the cube root of the elevation over
/// a right angle).
Weights bezier(double x) {
    constexpr Weights kBinomial = {1, 5, 10, 10, 5, 1};
    Weights weights{};
    for (std::size_t i = 0; i < weights.size(); ++i) {
        weights[i] =
            kBinomial[i] * std::pow(x, double(i)) * std::pow(1 - x, double(weights.size() - 1 - i));
    }
    return weights;
}

/// Interpolates a table over black ground: Bezier in elevation, linear in turbidity.
template <typename At>
float interpolate(const Weights& weights, double turbidity, const At& at) {
    const int last = HosekWilkieChannel::kTurbidities - 1;
    const int below = std::clamp(static_cast<int>(turbidity) - 1, 0, last);
    const int above = std::min(below + 1, last);
    const double share = turbidity - 1 - below;
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
        sum += weights[i] * std::lerp(double(at(below, i)), double(at(above, i)), share);
    return static_cast<float>(sum);
}

}  // namespace

HosekWilkieSky::HosekWilkieSky(const Vec3& sun, double turbidity) : sun_(sun) {
    const double elevation = std::asin(std::clamp(double(sun.z), 0.0, 1.0));
    const Weights weights = bezier(std::cbrt(elevation / (std::numbers::pi / 2)));
    constexpr double kLumensPerWatt = 683;
    for (std::size_t k = 0; k < xyz_.size(); ++k) {
        const HosekWilkieChannel& data = kHosekWilkieData[k];
        for (std::size_t i = 0; i < xyz_[k].c.size(); ++i) {
            xyz_[k].c[i] = interpolate(weights, turbidity, [&](int t, std::size_t p) {
                return data.coefficients[0][std::size_t(t)][p][i];
            });
        }
        xyz_[k].mean = static_cast<float>(kLumensPerWatt) *
                       interpolate(weights, turbidity, [&](int t, std::size_t p) {
                           return data.radiance[0][std::size_t(t)][p];
                       });
    }
}

/// Equation 8, with the anisotropic term of equation 9.
float HosekWilkieSky::distribution(const Channel& channel, float cos_theta, float gamma,
                                   float cos_gamma) {
    const auto& [a, b, c, d, e, f, g, i, h] = channel.c;
    constexpr float kAboveHorizon = 0.01f;  // equation 8's own
    const float cos2 = cos_gamma * cos_gamma;
    const float chi = (1 + cos2) / std::pow(1 + h * h - 2 * h * cos_gamma, 1.5f);
    return (1 + a * std::exp(b / (cos_theta + kAboveHorizon))) *
           (c + d * std::exp(e * gamma) + f * cos2 + g * chi + i * std::sqrt(cos_theta));
}

Rgb HosekWilkieSky::radiance(const Vec3& w) const {
    const float cos_theta = std::clamp(w.z, 0.0f, 1.0f);
    const float cos_gamma = std::clamp(w ^ sun_, -1.0f, 1.0f);
    const float gamma = std::acos(cos_gamma);
    Imath::V3d xyz(0.0);
    for (int k = 0; k < 3; ++k) {
        const Channel& channel = xyz_[std::size_t(k)];
        const double value =
            double(distribution(channel, cos_theta, gamma, cos_gamma)) * double(channel.mean);
        xyz[k] = std::isfinite(value) ? std::max(value, 0.0) : 0.0;
    }
    return clipped_rgb_of_xyz(xyz);
}

}  // namespace lxs
