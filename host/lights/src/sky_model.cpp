// Radiance of the clear sky (Preetham, Shirley & Smits 1999).
#include "sky_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lxs/spectrum/colour_matching.h"

namespace lxs {
namespace {

using Row = std::array<double, 4>;

/// Zenith chromaticity: (T^2, T, 1) times matrix times (angle^3, angle^2, angle, 1).
double zenith_chromaticity(const std::array<Row, 3>& m, double turbidity, double angle) {
    const auto cubic = [angle](const Row& r) {
        return ((r[0] * angle + r[1]) * angle + r[2]) * angle + r[3];
    };
    return (cubic(m[0]) * turbidity + cubic(m[1])) * turbidity + cubic(m[2]);
}

// Appendix A.2, zenith values.
constexpr std::array<Row, 3> kZenithX = {{{0.00166, -0.00375, 0.00209, 0.0},
                                          {-0.02903, 0.06377, -0.03202, 0.00394},
                                          {0.11693, -0.21196, 0.06052, 0.25886}}};
constexpr std::array<Row, 3> kZenithY = {{{0.00275, -0.00610, 0.00317, 0.0},
                                          {-0.04214, 0.08970, -0.04153, 0.00516},
                                          {0.15346, -0.26756, 0.06670, 0.26688}}};

}  // namespace

SkyModel::SkyModel(const Vec3& sun, double turbidity, const std::array<double, 5>& factors)
    : sun_(sun) {
    const double t = turbidity;
    const double angle = std::acos(std::clamp(double(sun.normalized().z), -1.0, 1.0));
    const double chi = (4.0 / 9.0 - t / 120.0) * (std::numbers::pi - 2 * angle);
    const double zenith =
        1000 * ((4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192);  // cd m^-2
    // Appendix A.2, distribution coefficients.
    const auto times = [&factors](std::array<double, 5> c) {
        for (std::size_t i = 0; i < c.size(); ++i)
            c[i] *= factors[i];
        return c;
    };
    luminance_ = make(times({0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251,
                             0.1206 * t - 2.5771, -0.0670 * t + 0.3703}),
                      std::max(0.0, zenith), angle);
    x_ = make(times({-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125,
                     -0.0641 * t - 0.8989, -0.0033 * t + 0.0452}),
              zenith_chromaticity(kZenithX, t, angle), angle);
    y_ = make(times({-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102,
                     -0.0441 * t - 1.6537, -0.0109 * t + 0.0529}),
              zenith_chromaticity(kZenithY, t, angle), angle);
}

SkyModel::Perez SkyModel::make(const std::array<double, 5>& c, double zenith, double sun_angle) {
    Perez perez;
    for (std::size_t i = 0; i < c.size(); ++i)
        perez.c[i] = static_cast<float>(c[i]);
    perez.scale = 1;
    const float gamma = static_cast<float>(sun_angle);
    const double at_zenith = evaluate(perez, 1.0f, gamma, std::cos(gamma));
    perez.scale = std::abs(at_zenith) > 0 ? static_cast<float>(zenith / at_zenith) : 0.0f;
    return perez;
}

float SkyModel::evaluate(const Perez& perez, float cos_theta, float gamma, float cos_gamma) {
    const auto& [a, b, c, d, e] = perez.c;
    constexpr float kLargest = 20;  // keeps unusual coefficients finite
    return perez.scale * (1 + a * std::exp(std::min(b / cos_theta, kLargest))) *
           (1 + c * std::exp(std::min(d * gamma, kLargest)) + e * cos_gamma * cos_gamma);
}

Rgb SkyModel::radiance(const Vec3& w) const {
    constexpr float kHorizon = 0.001f;  // the model divides by the cosine
    const float cos_theta = std::max(w.z, kHorizon);
    const float cos_gamma = std::clamp(w ^ sun_, -1.0f, 1.0f);
    const float gamma = std::acos(cos_gamma);
    const double luminance = evaluate(luminance_, cos_theta, gamma, cos_gamma);
    const double x = evaluate(x_, cos_theta, gamma, cos_gamma);
    const double y = evaluate(y_, cos_theta, gamma, cos_gamma);
    if (!(luminance > 0) || !(y > 0) || !std::isfinite(luminance)) return Rgb(0.0f);
    return clipped_rgb_of_xyz(
        Imath::V3d(luminance * x / y, luminance, luminance * std::max(0.0, 1 - x - y) / y));
}

}  // namespace lxs
