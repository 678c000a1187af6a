// Images of all directions in other layouts than latitude and longitude.
#include "environment_layout.h"

#include <algorithm>
#include <cmath>

#include "latlong_coordinates.h"

namespace lxs {
namespace {

Vec2 angular_coordinates(const Vec3& w) {
    const float sine = std::hypot(w.y, w.z);
    const float radius = std::acos(std::clamp(-w.x, -1.0f, 1.0f)) / (2 * kPi);
    if (!(sine > 0)) return Vec2(0.5f - (w.x > 0 ? 0.5f : 0.0f), 0.5f);
    return Vec2(0.5f - w.y * radius / sine, 0.5f - w.z * radius / sine);
}

/// A face of the cross: its cell, and where the direction passes through it, each in [-1, 1].
struct CrossFace {
    float column, row, x, y;
};

CrossFace cross_face(const Vec3& w) {
    const Vec3 a(std::abs(w.x), std::abs(w.y), std::abs(w.z));
    if (a.z > std::max(a.x, a.y)) {
        return w.z > 0 ? CrossFace{1, 0, -w.y / a.z, -w.x / a.z}
                       : CrossFace{1, 2, -w.y / a.z, w.x / a.z};
    }
    if (a.y > a.x) {
        return w.y > 0 ? CrossFace{0, 1, -w.x / a.y, -w.z / a.y}
                       : CrossFace{2, 1, w.x / a.y, -w.z / a.y};
    }
    return w.x > 0 ? CrossFace{1, 3, -w.y / a.x, w.z / a.x}
                   : CrossFace{1, 1, -w.y / a.x, -w.z / a.x};
}

/// `inset` of a face's half side keeps the interpolation within the face.
Vec2 cross_coordinates(const Vec3& w, float inset) {
    const CrossFace face = cross_face(w);
    const auto within = [inset](float v) { return std::clamp(v, inset - 1, 1 - inset); };
    return Vec2((face.column + (within(face.x) + 1) / 2) / 3,
                (face.row + (within(face.y) + 1) / 2) / 4);
}

}  // namespace

LatLongMap as_latlong(LatLongMap image, const std::string& mapping) {
    if (mapping == "latlong") return image;
    const std::size_t height = image.width(), width = 2 * height;
    if (mapping == "angular") {
        return LatLongMap::of(width, height, [&](const Vec2& st) {
            return image.lookup(angular_coordinates(latlong_direction(st)));
        });
    }
    const float inset = 3 / static_cast<float>(image.width());  // half a pixel of a face
    return LatLongMap::of(width, height, [&](const Vec2& st) {
        return image.lookup(cross_coordinates(latlong_direction(st), std::min(inset, 1.0f)));
    });
}

}  // namespace lxs
