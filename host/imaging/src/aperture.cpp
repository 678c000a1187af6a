// Where on the lens a camera ray starts.
#include "aperture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lxs/sdk/warp.h"

namespace lxs {
namespace {

constexpr int kFewestBlades = 3;

}  // namespace

Imath::V2d aperture_point(const Vec2& u, int blades) {
    if (blades < kFewestBlades) return square_to_concentric_disk(Imath::V2d(u));
    const double place = double(u.x) * blades;
    const int side = std::min(static_cast<int>(place), blades - 1);
    // Uniform over the triangle of the centre and two corners (Pharr & Humphreys 2010, 13.6.5).
    const double root = std::sqrt(place - side), along = double(u.y);
    const auto corner = [&](int i) {
        const double angle = 2 * std::numbers::pi * i / blades;
        return Imath::V2d(std::cos(angle), std::sin(angle));
    };
    return (corner(side) * (1 - along) + corner(side + 1) * along) * root;
}

Vec2 aperture_centre(int blades) {
    return blades < kFewestBlades ? Vec2(0.5f) : Vec2(0.0f);
}

}  // namespace lxs
