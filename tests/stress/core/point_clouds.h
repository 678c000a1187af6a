// Points that trees and grids are tried with: all at one place, on lines and planes, between
// neighbouring floats, and spread out; at any scale and place.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "aips/core/base/bounds.h"
#include "aips/core/sampling/random.h"

namespace stress {

/// Coordinates are in [0, 1] before they are scaled and moved.
struct Cloud {
    std::string name;
    std::vector<aips::Vec3> points;
};

/// Where a cloud lies: x becomes offset + scale * x, in single precision.
struct Placement {
    float scale = 1;
    float offset = 0;

    aips::Vec3 place(aips::Vec3 p) const { return p * scale + aips::Vec3{offset, offset, offset}; }
    std::vector<aips::Vec3> place(const std::vector<aips::Vec3>& points) const {
        std::vector<aips::Vec3> placed;
        placed.reserve(points.size());
        for (const aips::Vec3 p : points)
            placed.push_back(place(p));
        return placed;
    }
    aips::Bounds box() const { return {place({0, 0, 0}), place({1, 1, 1})}; }
    std::string name() const {
        return std::to_string(scale) + " units wide at " + std::to_string(offset);
    }
};

/// Scenes of 1e-6 to 1e6 units, in the origin and a million of their own widths away from it: there
/// a coordinate has some 16 different values.
inline std::vector<Placement> placements() {
    std::vector<Placement> all;
    for (const float scale : {1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f}) {
        for (const float widths : {0.0f, 1e4f, 1e6f})
            all.push_back({scale, scale * widths});
    }
    return all;
}

/// `count` points each.
inline std::vector<Cloud> clouds(int count) {
    using aips::Vec3;
    aips::RandomStream random(1, 0, 0, aips::RandomDomain::Photon);
    std::vector<Cloud> all{{"one point", {}},      {"axis-aligned line", {}},
                           {"diagonal line", {}},  {"aligned plane", {}},
                           {"tilted plane", {}},   {"two points", {}},
                           {"needle extents", {}}, {"halving steps", {}},
                           {"lattice", {}},        {"box", {}}};
    for (int i = 0; i < count; ++i) {
        const float x = random.next(), y = random.next(), z = random.next();
        const float next = std::nextafter(0.5f, 1.0f);
        const float step = std::ldexp(1.0f, -i % 120);
        const Vec3 points[] = {{0.3f, 0.7f, 0.1f},
                               {x, 0.25f, 0.5f},
                               {x, x, x},
                               {x, y, 0.5f},
                               {x, y, 0.5f * (x + y)},
                               {0.5f, 0.5f, i % 2 ? 0.5f : next},
                               {x, 1e-7f * y, 1e-7f * z},
                               {step, step, step},
                               {float(i % 8) / 8, float(i / 8 % 8) / 8, float(i / 64 % 8) / 8},
                               {x, y, z}};
        for (std::size_t c = 0; c < all.size(); ++c)
            all[c].points.push_back(points[c]);
    }
    return all;
}

/// Places that no structure may take.
inline std::vector<aips::Vec3> impossible_points() {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::nanf("");
    return {{nan, 0, 0}, {0, nan, 0}, {0, 0, nan}, {inf, 0, 0}, {0, -inf, 0}, {nan, inf, -inf}};
}

}  // namespace stress
