// Random points in space, one a cell of the integer lattice, and random numbers by cell.
#include "cell_points.h"

#include <algorithm>
#include <cmath>

#include "hashed_bits.h"

namespace lxs::shading {
namespace {

/// Of a whole coordinate, which may lie beyond any integer.
std::uint32_t key(float whole) {
    constexpr float kPeriod = 16777216;  // 2^24: neighbours further out are the same number
    return static_cast<std::uint32_t>(whole - kPeriod * std::floor(whole / kPeriod));
}

float number(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) * 0x1p-24f;
}

std::uint32_t cell_bits(const Vec3& cell) {
    return hashed(hashed(hashed(key(cell.x)) + key(cell.y)) + key(cell.z));
}

Vec3 floor_of(const Vec3& p) {
    return {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
}

bool is_finite(const Vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

float minkowski(const Vec3& d, float exponent) {
    return std::pow(std::pow(d.x, exponent) + std::pow(d.y, exponent) + std::pow(d.z, exponent),
                    1 / exponent);
}

float distance(const Vec3& offset, DistanceMetric metric, float exponent) {
    const Vec3 d(std::abs(offset.x), std::abs(offset.y), std::abs(offset.z));
    switch (metric) {
        case DistanceMetric::Squared:
            return d.length2();
        case DistanceMetric::Manhattan:
            return d.x + d.y + d.z;
        case DistanceMetric::Chebychev:
            return std::max({d.x, d.y, d.z});
        case DistanceMetric::MinkowskiHalf:
            return minkowski(d, 0.5f);
        case DistanceMetric::MinkowskiFour:
            return minkowski(d, 4);
        case DistanceMetric::Minkowski:
            return minkowski(d, exponent);
        case DistanceMetric::Actual:
            break;
    }
    return d.length();
}

}  // namespace

std::array<float, 4> nearest_points(const Vec3& p, DistanceMetric metric, float exponent) {
    if (!is_finite(p)) return {};
    std::array<float, 4> nearest;
    nearest.fill(std::numeric_limits<float>::max());
    const Vec3 home = floor_of(p), within = p - home;
    for (int i = 0; i < 27; ++i) {
        const int x = i % 3 - 1, y = i / 3 % 3 - 1, z = i / 9 - 1;
        const Vec3 step(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
        const std::uint32_t bits = cell_bits(home + step);
        const Vec3 point(number(bits), number(hashed(bits + 1)), number(hashed(bits + 2)));
        const float found = distance(step + point - within, metric, exponent);
        if (!(found < nearest.back())) continue;
        nearest.back() = found;
        std::sort(nearest.begin(), nearest.end());
    }
    return nearest;
}

float cell_value(const Vec3& p) {
    return is_finite(p) ? number(cell_bits(floor_of(p))) : 0;
}

}  // namespace lxs::shading
