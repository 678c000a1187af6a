// Optical constants per channel that give a metal the colour that its spectrum has.
#include "metal_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "bsdfs/fresnel.h"
#include "lxs/spectrum/colour_matching.h"
#include "lxs/spectrum/reflectance_colour.h"

namespace lxs::shading {
namespace {

/// Cosines at which the reflectances are compared, evenly spaced.
constexpr std::size_t kAngles = 12;
constexpr double kLargestShare = 0.9999;
using Reflectances = std::array<double, kAngles>;

double cosine(std::size_t i) {
    return static_cast<double>(i + 1) / kAngles;
}

std::array<Reflectances, 3> colours_by_angle(const OpticalTable& table) {
    std::array<Reflectances, 3> colours{};
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm) {
        const OpticalConstants at = constants_at(table, nm);
        const Imath::V3d response = white_lamp_response(nm);
        for (std::size_t i = 0; i < kAngles; ++i) {
            const double share = metal_reflectance(cosine(i), at.n, at.k);
            for (std::size_t c = 0; c < 3; ++c)
                colours[c][i] += response[static_cast<int>(c)] * share;
        }
    }
    for (Reflectances& channel : colours) {
        for (double& share : channel)
            share = std::clamp(share, 0.0, kLargestShare);
    }
    return colours;
}

/// Logarithms of index and extinction.
struct Constants {
    double log_n, log_k;
};

Reflectances differences(const Constants& at, const Reflectances& wanted) {
    const FresnelValue value{Rgb(static_cast<float>(std::exp(at.log_n))),
                             Rgb(static_cast<float>(std::exp(at.log_k))), true};
    Reflectances result;
    for (std::size_t i = 0; i < kAngles; ++i)
        result[i] = double{fresnel_conductor(static_cast<float>(cosine(i)), value).x} - wanted[i];
    return result;
}

double sum_of_squares(const Reflectances& r) {
    double sum = 0;
    for (const double v : r)
        sum += v * v;
    return sum;
}

/// Levenberg & Marquardt's least squares from `start`.
Constants fitted(Constants best, const Reflectances& wanted) {
    constexpr int kSteps = 60;
    constexpr double kDelta = 1e-2, kLowest = -4.5, kHighest = 4.5;
    double damping = 1e-2;
    Reflectances r = differences(best, wanted);
    for (int step = 0; step < kSteps; ++step) {
        const Reflectances rn = differences({best.log_n + kDelta, best.log_k}, wanted);
        const Reflectances rk = differences({best.log_n, best.log_k + kDelta}, wanted);
        double nn = 0, nk = 0, kk = 0, n = 0, k = 0;
        for (std::size_t i = 0; i < kAngles; ++i) {
            const double dn = (rn[i] - r[i]) / kDelta, dk = (rk[i] - r[i]) / kDelta;
            nn += dn * dn, nk += dn * dk, kk += dk * dk;
            n += dn * r[i], k += dk * r[i];
        }
        nn *= 1 + damping, kk *= 1 + damping;
        const double determinant = nn * kk - nk * nk;
        if (!(determinant > 0)) break;
        const Constants tried{
            std::clamp(best.log_n - (n * kk - k * nk) / determinant, kLowest, kHighest),
            std::clamp(best.log_k - (k * nn - n * nk) / determinant, kLowest, kHighest)};
        const Reflectances next = differences(tried, wanted);
        const bool better = sum_of_squares(next) < sum_of_squares(r);
        damping = better ? damping * 0.3 : damping * 4;
        if (!better) continue;
        best = tried;
        r = next;
    }
    return best;
}

}  // namespace

double metal_reflectance(double c, double n, double k) {
    const double size = n * n + k * k, across = 2 * n * c;
    const double parallel = size * c * c + 1, perpendicular = size + c * c;
    return 0.5 * ((parallel - across) / (parallel + across) +
                  (perpendicular - across) / (perpendicular + across));
}

FresnelValue constants_of_colour(const OpticalTable& table) {
    FresnelValue value = rgb_constants(table);
    const bool varies = std::any_of(table.begin(), table.end(), [&](const auto& entry) {
        return entry.n != table[0].n || entry.k != table[0].k;
    });
    if (!value.conductor || !varies) return value;
    const std::array<Reflectances, 3> colours = colours_by_angle(table);
    for (int c = 0; c < 3; ++c) {
        const Constants start{std::log(std::max(double{value.eta[c]}, 1e-2)),
                              std::log(std::max(double{value.k[c]}, 1e-2))};
        const Constants found = fitted(start, colours[static_cast<std::size_t>(c)]);
        value.eta[c] = static_cast<float>(std::exp(found.log_n));
        value.k[c] = static_cast<float>(std::exp(found.log_k));
    }
    return value;
}

}  // namespace lxs::shading
