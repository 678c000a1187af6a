// How the intensity of a light at a point depends on direction.
#include "emission_profile.h"

#include <cmath>

#include "latlong_coordinates.h"

namespace lxs {

SphereProfile::SphereProfile(const Rotation& rotation, LatLongMap map)
    : rotation_(rotation), map_(std::move(map)), importance_(map_.importance()) {}

SphereProfile::SphereProfile(const Rotation& rotation, LatLongMap map, Piecewise2D importance)
    : rotation_(rotation), map_(std::move(map)), importance_(std::move(importance)) {}

Rgb SphereProfile::at(const Vec3& w) const {
    return map_.lookup(latlong_coordinates(rotation_.to_local(w)));
}

float SphereProfile::sample(const Vec2& u, Vec3& w) const {
    if (!importance_.positive()) return 0;
    float density = 0;
    const Vec2 st = importance_.sample(u, density);
    w = rotation_.to_world(latlong_direction(st)).normalized();
    return latlong_density(density, st.y);
}

bool SphereProfile::coordinates(const Vec3& w, Vec2& u) const {
    return importance_.coordinates(latlong_coordinates(rotation_.to_local(w)), u);
}

ScreenProfile::ScreenProfile(const Frame& axes, LatLongMap image, float fov, bool plain)
    : axes_(axes), image_(std::move(image)), plain_(plain) {
    const float aspect = static_cast<float>(image_.width()) / static_cast<float>(image_.height());
    const float half_side = std::tan(fov / 2);
    half_ = Vec2(std::max(aspect, 1.0f), std::max(1 / aspect, 1.0f)) * half_side;
    area_ = 4 * half_side * half_side / aspect;
    // What a pixel gets of the emission over its solid angle.
    const auto weight = [&](const Vec2& st) {
        return plain_ ? std::pow(double(local_direction(st).z), 3) : 1.0;
    };
    importance_ = image_.importance(weight);
    integral_ = image_.integral(weight) * (4 * half_.x * half_.y / (plain_ ? 1 : area_));
}

Vec3 ScreenProfile::local_direction(const Vec2& st) const {
    return Vec3((2 * st.x - 1) * half_.x, (2 * st.y - 1) * half_.y, 1).normalized();
}

bool ScreenProfile::image_place(const Vec3& w, Vec2& st) const {
    const Vec3 local = axes_.to_local(w);
    if (!(local.z > 0)) return false;
    st = Vec2((local.x / (local.z * half_.x) + 1) / 2, (local.y / (local.z * half_.y) + 1) / 2);
    return st.x >= 0 && st.x < 1 && st.y >= 0 && st.y < 1;
}

Rgb ScreenProfile::at(const Vec3& w) const {
    Vec2 st;
    if (!image_place(w, st)) return Rgb(0.0f);
    if (plain_) return image_.lookup(st);
    const float cosine = local_direction(st).z;
    return image_.lookup(st) / (area_ * cosine * cosine * cosine);
}

float ScreenProfile::sample(const Vec2& u, Vec3& w) const {
    if (!importance_.positive()) return 0;
    float density = 0;
    const Vec2 st = importance_.sample(u, density);
    const Vec3 local = local_direction(st);
    w = axes_.to_world(local).normalized();
    return density / (4 * half_.x * half_.y * local.z * local.z * local.z);
}

bool ScreenProfile::coordinates(const Vec3& w, Vec2& u) const {
    Vec2 st;
    return image_place(w, st) && importance_.coordinates(st, u);
}

}  // namespace lxs
