// Colour spaces: sRGB, DCI-P3, Rec. 2020, ACES 2065-1.
#include "colour_space.h"

#include <array>

#include "lxs/spectrum/colour_matching.h"

namespace lxs::pbrt {
namespace {

using Imath::M33d;
using Imath::V3d;

using Chromaticity = std::array<double, 2>;

V3d xyz_of(const Chromaticity& c) {
    return {c[0] / c[1], 1, (1 - c[0] - c[1]) / c[1]};
}

/// Rows are the tristimulus values of pure red, green and blue, which add up to the white.
M33d xyz_of_primaries(const std::array<Chromaticity, 4>& primaries) {
    M33d rows;
    for (int i = 0; i < 3; ++i) {
        const V3d xyz = xyz_of(primaries[static_cast<std::size_t>(i)]);
        for (int j = 0; j < 3; ++j)
            rows[i][j] = xyz[j];
    }
    const V3d share = xyz_of(primaries[3]) * rows.inverse();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            rows[i][j] *= share[i];
    return rows;
}

ColourSpace made(std::string name, const std::array<Chromaticity, 4>& primaries) {
    const M33d xyz = xyz_of_primaries(primaries);
    ColourSpace space{std::move(name), {}};
    for (int i = 0; i < 3; ++i) {
        const V3d rgb = rgb_of_xyz({xyz[i][0], xyz[i][1], xyz[i][2]});
        for (int j = 0; j < 3; ++j)
            space.to_linear[i][j] = rgb[j];
    }
    return space;
}

const std::vector<ColourSpace>& spaces() {
    constexpr Chromaticity kD65{0.3127, 0.3290};
    static const std::vector<ColourSpace> all{
        {"srgb", M33d()},
        made("dci-p3", {{{0.68, 0.32}, {0.265, 0.69}, {0.15, 0.06}, kD65}}),
        made("rec2020", {{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, kD65}}),
        made("aces2065-1",
             {{{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, {0.32168, 0.33767}}})};
    return all;
}

Rgb positive(const V3d& c) {
    return Rgb(static_cast<float>(std::max(c.x, 0.0)), static_cast<float>(std::max(c.y, 0.0)),
               static_cast<float>(std::max(c.z, 0.0)));
}

}  // namespace

const ColourSpace* colour_space(const std::string& name) {
    for (const ColourSpace& space : spaces())
        if (space.name == name) return &space;
    return nullptr;
}

const ColourSpace& srgb() {
    return spaces().front();
}

std::vector<std::string> colour_space_names() {
    std::vector<std::string> names;
    for (const ColourSpace& space : spaces())
        names.push_back(space.name);
    return names;
}

Rgb light_in(const ColourSpace& space, const Rgb& rgb) {
    return &space == &srgb() ? rgb : positive(V3d(rgb.x, rgb.y, rgb.z) * space.to_linear);
}

Rgb surface_in(const ColourSpace& space, const Rgb& rgb) {
    if (&space == &srgb()) return rgb;
    const V3d white = V3d(1, 1, 1) * space.to_linear;
    return positive(V3d(rgb.x, rgb.y, rgb.z) * space.to_linear / white);
}

}  // namespace lxs::pbrt
