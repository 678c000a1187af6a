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

/// Where a direction lies in an equal-area octahedral map: Clarberg 2008, "Fast equal-area mapping
/// of the (hemi)sphere using SIMD". +z is in the middle, -z at the corners.
Vec2 equal_area_coordinates(const Vec3& w) {
    const float r = std::sqrt(std::max(0.0f, 1 - std::abs(w.z)));
    const float turn = std::atan2(std::abs(w.y), std::abs(w.x)) * 2 / kPi;
    float u = r - turn * r, v = turn * r;
    if (w.z < 0) {
        const float folded = 1 - v;
        v = 1 - u;
        u = folded;
    }
    return Vec2((std::copysign(u, w.x) + 1) / 2, (std::copysign(v, w.y) + 1) / 2);
}

/// A pixel of such a map, whose border goes on at the mirrored place of the same edge.
Rgb equal_area_pixel(const LatLongMap& image, std::ptrdiff_t x, std::ptrdiff_t y) {
    const auto w = static_cast<std::ptrdiff_t>(image.width()),
               h = static_cast<std::ptrdiff_t>(image.height());
    if (x < 0 || x >= w) {
        x = std::clamp<std::ptrdiff_t>(x < 0 ? -1 - x : 2 * w - 1 - x, 0, w - 1);
        y = h - 1 - y;
    }
    if (y < 0 || y >= h) {
        y = std::clamp<std::ptrdiff_t>(y < 0 ? -1 - y : 2 * h - 1 - y, 0, h - 1);
        x = w - 1 - x;
    }
    return image.pixel(x, y);
}

Rgb equal_area_lookup(const LatLongMap& image, const Vec3& w) {
    const Vec2 at = equal_area_coordinates(w);
    const float x = at.x * static_cast<float>(image.width()) - 0.5f;
    const float y = at.y * static_cast<float>(image.height()) - 0.5f;
    const auto x0 = static_cast<std::ptrdiff_t>(std::floor(x)),
               y0 = static_cast<std::ptrdiff_t>(std::floor(y));
    const float dx = x - static_cast<float>(x0), dy = y - static_cast<float>(y0);
    const auto pixel = [&](std::ptrdiff_t i, std::ptrdiff_t j) {
        return equal_area_pixel(image, x0 + i, y0 + j);
    };
    return (pixel(0, 0) * (1 - dx) + pixel(1, 0) * dx) * (1 - dy) +
           (pixel(0, 1) * (1 - dx) + pixel(1, 1) * dx) * dy;
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
    if (mapping == "equalarea") {
        // As many rows as the square has: near the horizon, where most directions are, texels of
        // both are about as high.
        return LatLongMap::of(2 * image.height(), image.height(), [&](const Vec2& st) {
            return equal_area_lookup(image, latlong_direction(st));
        });
    }
    const float inset = 3 / static_cast<float>(image.width());  // half a pixel of a face
    return LatLongMap::of(width, height, [&](const Vec2& st) {
        return image.lookup(cross_coordinates(latlong_direction(st), std::min(inset, 1.0f)));
    });
}

}  // namespace lxs
