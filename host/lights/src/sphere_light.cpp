// Area light of a whole sphere seen from outside: samples the cone that it subtends
// (Shirley, Wang & Zimmerman 1996, "Monte Carlo techniques for direct lighting calculations").
#include "sphere_light.h"

#include <algorithm>
#include <cmath>

#include "warp.h"

namespace lxs {

SphereLight::SphereLight(const Primitive& primitive, const AreaEmission& emission,
                         const Matrix& to_world, const Matrix& object_to_world)
    : SurfaceLight(primitive, emission, object_to_world), center_(Vec3(to_world.translation())) {
    const auto row = [&](int i) {
        return Imath::V3d(to_world[i][0], to_world[i][1], to_world[i][2]);
    };
    const double radius = row(0).length();
    radius_ = static_cast<float>(radius);
    x_ = Vec3(row(0).normalized());
    y_ = Vec3(row(1).normalized());
    z_ = Vec3(row(2).normalized());
    const auto bound = [this](float c) { return rounding_bound(6) * (std::abs(c) + radius_); };
    error_ = Vec3(bound(center_.x), bound(center_.y), bound(center_.z));
    const double area = 4 * std::numbers::pi * radius * radius;
    density_ = area > 0 ? static_cast<float>(1 / area) : 0;
    set_emission(emission, area);
}

SurfacePoint SphereLight::point_at(const Vec3& n) const {
    SurfacePoint s;
    s.n = n;
    s.p = center_ + n * radius_;
    s.p_error = error_;
    s.density = density_;
    if (!has_constant_emission()) {
        const float phi = std::atan2(n ^ y_, n ^ x_);
        const float theta = std::acos(std::clamp(n ^ z_, -1.0f, 1.0f));
        s.uv = Vec2((phi < 0 ? phi + 2 * kPi : phi) / (2 * kPi), 1.0f - theta / kPi);
    }
    return s;
}

SurfacePoint SphereLight::sample_surface(const Vec2& u) const {
    return point_at(uniform_sphere(double(u.x), u.y));
}

bool SphereLight::surface_coordinates(const Vec3& p, std::uint32_t /*primitive*/, Vec2& u) const {
    const Vec2 found(from_uniform_sphere((p - center_).normalized()));
    u = Vec2(clamp_to_unit(found.x), found.y);
    return true;
}

float SphereLight::cone(float distance2) const {
    const float sin2 = radius_ * radius_ / distance2;
    if (!(sin2 < 1)) return 0;
    return sin2 / (1.0f + std::sqrt(1.0f - sin2));
}

bool SphereLight::sample_direct(const Vec3& p, const Vec3& /*n*/, const Vec2& u,
                                DirectSample& sample) const {
    sample.pdf = 0;
    const Vec3 to_center = center_ - p;
    const float distance2 = to_center.length2();
    const float one_minus_cos_max = cone(distance2);
    const float pdf = 1.0f / (2.0f * kPi * one_minus_cos_max);
    if (!(one_minus_cos_max > 0) || !std::isfinite(pdf)) return false;
    const float distance = std::sqrt(distance2);
    const float one_minus_cos = u.x * one_minus_cos_max;
    const Vec3 wi = Frame(to_center / distance).to_world(around_z(one_minus_cos, u.y)).normalized();
    const float sin2 = one_minus_cos * (2.0f - one_minus_cos);
    const float half_chord2 = radius_ * radius_ - distance2 * sin2;
    const float t = distance * (1.0f - one_minus_cos) - std::sqrt(std::max(0.0f, half_chord2));
    if (!(t > 0)) return false;
    const SurfacePoint s = point_at((p + wi * t - center_).normalized());
    sample = {wi, t, segment_end(s, wi, t), emitted(s, -wi), pdf, false};
    return true;
}

float SphereLight::pdf_direct(const Vec3& p, const Vec3& /*n*/, const Vec3& wi,
                              const Vec3& /*light_p*/, const Vec3& light_n,
                              std::uint32_t /*primitive*/) const {
    const float one_minus_cos_max = cone((center_ - p).length2());
    if (!(one_minus_cos_max > 0) || (light_n ^ wi) >= 0) return 0;
    const float pdf = 1.0f / (2.0f * kPi * one_minus_cos_max);
    return std::isfinite(pdf) ? pdf : 0;
}

}  // namespace lxs
