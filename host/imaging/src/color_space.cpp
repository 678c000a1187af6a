// The film's colour space.
#include "color_space.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "finite_float.h"

namespace lxs {
namespace {

/// XYZ of luminance 1.
Imath::V3d xyz(const std::array<double, 2>& c) {
    return {c[0] / c[1], 1, (1 - c[0] - c[1]) / c[1]};
}

/// RGB row vector times it is XYZ; white is (1, 1, 1) (Pharr & Humphreys 2010, section 5.2; SMPTE
/// RP 177).
Imath::M33d to_xyz(const ColorSpace& space) {
    const Imath::V3d r = xyz(space.red), g = xyz(space.green), b = xyz(space.blue);
    Imath::M33d primaries(r.x, r.y, r.z, g.x, g.y, g.z, b.x, b.y, b.z);
    const double determinant = primaries.determinant();
    if (!std::isfinite(determinant) || std::abs(determinant) < 1e-9)
        throw std::invalid_argument("the primaries span no colours");
    const Imath::V3d white = xyz(space.white) * primaries.inverse();
    if (!std::isfinite(white.length2())) throw std::invalid_argument("the white is no colour");
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            primaries[i][k] *= white[i];
    if (std::abs(primaries.determinant()) < 1e-12)
        throw std::invalid_argument("the white lies on a side of the primaries");
    return primaries;
}

using Chromaticity = std::array<double, 2>;

/// The point nearest to `p` of the line from `a` to `b`.
Chromaticity nearest_between(const Chromaticity& a, const Chromaticity& b, const Chromaticity& p) {
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double along = (p[0] - a[0]) * dx + (p[1] - a[1]) * dy;
    const double t = std::clamp(along / (dx * dx + dy * dy), 0.0, 1.0);
    return {a[0] + t * dx, a[1] + t * dy};
}

double squared_distance(const Chromaticity& a, const Chromaticity& b) {
    const double dx = a[0] - b[0], dy = a[1] - b[1];
    return dx * dx + dy * dy;
}

/// Of chromaticities outside of the triangle of the primaries.
Chromaticity nearest_on_border(const ColorSpace& space, const Chromaticity& p) {
    Chromaticity best = nearest_between(space.red, space.green, p);
    for (const Chromaticity& q :
         {nearest_between(space.green, space.blue, p), nearest_between(space.blue, space.red, p)}) {
        if (squared_distance(q, p) < squared_distance(best, p)) best = q;
    }
    return best;
}

Rgb positive(const Imath::V3d& c) {
    const auto clip = [](double v) { return finite_float(std::max(v, 0.0)); };
    return Rgb(clip(c.x), clip(c.y), clip(c.z));
}

}  // namespace

ColorConversion::ColorConversion(const ColorSpace& from, const ColorSpace& to)
    : to_(to), to_xyz_(to_xyz(from)), from_xyz_(to_xyz(to).inverse()) {
    matrix_ = to_xyz_ * from_xyz_;
    const Imath::M33d film = to_xyz(to);
    luminance_weights_ = {film[0][1], film[1][1], film[2][1]};
}

Rgb ColorConversion::operator()(const Rgb& c) const {
    const Imath::V3d result = Imath::V3d(c) * matrix_;
    if (result.x >= 0 && result.y >= 0 && result.z >= 0) return positive(result);
    return constrained(Imath::V3d(c) * to_xyz_);
}

Rgb ColorConversion::constrained(const Imath::V3d& xyz) const {
    const double sum = xyz.x + xyz.y + xyz.z;
    if (!(xyz.y > 0) || !(sum > 0)) return Rgb(0.0f);
    const Chromaticity border = nearest_on_border(to_, {xyz.x / sum, xyz.y / sum});
    return positive(lxs::xyz(border) * xyz.y * from_xyz_);
}

}  // namespace lxs
