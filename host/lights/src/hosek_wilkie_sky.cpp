// Radiance of the clear sky (Hosek & Wilkie 2012).
#include "hosek_wilkie_sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "hosek_wilkie_data.h"
#include "lxs/spectrum/colour_matching.h"

namespace lxs {
namespace {

constexpr int kControlPoints = HosekWilkieBand::kControlPoints;
using Weights = std::array<double, kControlPoints>;

/// Coefficients A B C D E F G I H of equation 8 and the mean radiance at one wavelength.
using Coefficients = std::array<double, HosekWilkieBand::kCoefficients + 1>;

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

/// Interpolates a table: Bezier in elevation, linear in turbidity.
template <typename At>
double interpolate(const Weights& weights, double turbidity, const At& at) {
    const int last = HosekWilkieBand::kTurbidities - 1;
    const int below = std::clamp(static_cast<int>(turbidity) - 1, 0, last);
    const int above = std::min(below + 1, last);
    const double share = turbidity - 1 - below;
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += weights[i] * std::lerp(double(at(std::size_t(below), i)),
                                      double(at(std::size_t(above), i)), share);
    }
    return sum;
}

using Bands = std::array<Coefficients, std::tuple_size_v<HosekWilkieData>>;

Bands bands_of(double elevation, double turbidity) {
    const Weights weights = bezier(std::cbrt(elevation / (std::numbers::pi / 2)));
    Bands bands;
    for (std::size_t k = 0; k < bands.size(); ++k) {
        const HosekWilkieBand& data = kHosekWilkieData[k];
        for (std::size_t i = 0; i + 1 < bands[k].size(); ++i) {
            bands[k][i] = interpolate(weights, turbidity, [&](std::size_t t, std::size_t p) {
                return data.coefficients[t][p][i];
            });
        }
        bands[k].back() = interpolate(
            weights, turbidity, [&](std::size_t t, std::size_t p) { return data.radiance[t][p]; });
    }
    return bands;
}

/// As LuxRender: the coefficients are linear in the wavelength between those of the data.
Coefficients at_wavelength(const Bands& bands, double nm) {
    const double place = (nm - kHosekWilkieFirstNm) / kHosekWilkieStepNm;
    const std::size_t below = std::min(static_cast<std::size_t>(place), bands.size() - 2);
    Coefficients c;
    for (std::size_t i = 0; i < c.size(); ++i)
        c[i] = std::lerp(bands[below][i], bands[below + 1][i], place - double(below));
    return c;
}

/// Equation 8, with the anisotropic term of equation 9, times the mean radiance.
double radiance_of(const Coefficients& coefficients, double cos_theta, double cos_gamma) {
    const auto& [a, b, c, d, e, f, g, i, h, mean] = coefficients;
    constexpr double kAboveHorizon = 0.01;  // equation 8's own
    const double cos2 = cos_gamma * cos_gamma;
    const double chi = (1 + cos2) / std::pow(1 + h * h - 2 * h * cos_gamma, 1.5);
    return mean * (1 + a * std::exp(b / (cos_theta + kAboveHorizon))) *
           (c + d * std::exp(e * std::acos(cos_gamma)) + f * cos2 + g * chi +
            i * std::sqrt(cos_theta));
}

/// A wavelength at which the model is evaluated, and what its radiance adds to XYZ.
struct Node {
    Coefficients coefficients;
    Imath::V3d matching{0.0};
};

std::vector<Node> nodes_of(double elevation, double turbidity) {
    constexpr double kFirstNm = 380, kLastNm = 720, kStepNm = 2;  // LuxRender's range
    constexpr double kLumensPerWatt = 683;
    const Bands bands = bands_of(elevation, turbidity);
    std::vector<Node> nodes;
    for (double nm = kFirstNm; nm <= kLastNm; nm += kStepNm) {
        Node node{at_wavelength(bands, nm)};
        for (double away = 1 - kStepNm; away < kStepNm; ++away) {
            if (nm + away < kFirstNm || nm + away > kLastNm) continue;
            node.matching +=
                colour_matching(nm + away) * (kLumensPerWatt * (1 - std::abs(away) / kStepNm));
        }
        nodes.push_back(node);
    }
    return nodes;
}

/// Even steps of the table are even in the square roots of cos(theta) and gamma.
double squared(std::size_t i, std::size_t count) {
    const double x = double(i) / double(count - 1);
    return x * x;
}

struct Cell {
    std::size_t below;
    float share;
};

Cell cell_of(float fraction, std::size_t count) {
    const float place = std::sqrt(fraction) * static_cast<float>(count - 1);
    const auto below = std::min(static_cast<std::size_t>(place), count - 2);
    return {below, place - static_cast<float>(below)};
}

}  // namespace

HosekWilkieSky::HosekWilkieSky(const Vec3& sun, double turbidity)
    : sun_(sun), table_(kHeights * kAngles) {
    const double elevation = std::asin(std::clamp(double(sun.z), 0.0, 1.0));
    const std::vector<Node> nodes = nodes_of(elevation, turbidity);
    for (std::size_t angle = 0; angle < kAngles; ++angle) {
        const double cos_gamma = std::cos(std::numbers::pi * squared(angle, kAngles));
        for (std::size_t height = 0; height < kHeights; ++height) {
            Imath::V3d xyz(0.0);
            for (const Node& node : nodes) {
                const double value =
                    radiance_of(node.coefficients, squared(height, kHeights), cos_gamma);
                // Hazy skies of a low sun dip below 0 here and there, as they do in LuxRender.
                if (std::isfinite(value)) xyz += node.matching * value;
            }
            table_[angle * kHeights + height] = clipped_rgb_of_xyz(xyz);
        }
    }
}

Rgb HosekWilkieSky::radiance(const Vec3& w) const {
    const float gamma = std::acos(std::clamp(w ^ sun_, -1.0f, 1.0f));
    const Cell height = cell_of(std::clamp(w.z, 0.0f, 1.0f), kHeights);
    const Cell angle = cell_of(gamma * std::numbers::inv_pi_v<float>, kAngles);
    const auto along = [&](std::size_t row) {
        return entry(height.below, row) * (1 - height.share) +
               entry(height.below + 1, row) * height.share;
    };
    return along(angle.below) * (1 - angle.share) + along(angle.below + 1) * angle.share;
}

}  // namespace lxs
