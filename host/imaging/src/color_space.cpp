// The film's colour space.
#include "color_space.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

}  // namespace

Imath::M33d rgb_matrix(const ColorSpace& from, const ColorSpace& to) {
    return to_xyz(from) * to_xyz(to).inverse();
}

Rgb converted(const Imath::M33d& m, const Rgb& c) {
    const Imath::V3d result = Imath::V3d(c) * m;
    const auto clip = [](double v) { return static_cast<float>(std::max(v, 0.0)); };
    return Rgb(clip(result.x), clip(result.y), clip(result.z));
}

}  // namespace lxs
