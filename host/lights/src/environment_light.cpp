// Base of lights at infinity: photons come through a disk as wide as the scene's sphere.
#include "environment_light.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "warp.h"

namespace lxs {

using Imath::V2d;
using Imath::V3d;

EnvironmentLight::EnvironmentLight(const LightPlacement& placement, std::string_view kind,
                                   const SceneSphere& sphere)
    : PlacedLight(placement), kind_(kind), sphere_(sphere) {
    if (!(sphere_.radius > 0) || !std::isfinite(sphere_.radius)) sphere_ = SceneSphere{};
    if (sphere_.surfaces.isEmpty()) return;
    const Bounds& box = sphere_.surfaces;
    float farthest = 0;
    for (int axis = 0; axis < 3; ++axis)
        farthest = std::max({farthest, std::abs(box.min[axis]), std::abs(box.max[axis])});
    margin_ = 0x1p-13 * double(sphere_.radius) + 0x1p-21 * double(farthest);
}

void EnvironmentLight::set_fluence(const Rgb& fluence) {
    fluence_ = luminance(fluence);
}

void EnvironmentLight::set_fluence(const Rgb& fluence, const Vec3& from) {
    fluence_ = luminance(fluence);
    facing_ = {std::abs(from.x), std::abs(from.y), std::abs(from.z)};
}

float EnvironmentLight::crossed_area() const {
    const float disc = kPi * sphere_.radius * sphere_.radius;
    if (in_medium() || sphere_.surfaces.isEmpty()) return disc;
    const Vec3 size = sphere_.surfaces.size() + Vec3(static_cast<float>(margin_));
    return std::min(disc, facing_.dot({size.y * size.z, size.z * size.x, size.x * size.y}));
}

// A ray's origin is of single precision: at 10 km its coordinates are a millimetre apart, and
// parallel light from there would fall on lines that far apart, however fine the primary
// coordinates are. So photons start where their line comes to the box around all surfaces: a view
// on a wide ground has the origins' coordinates small where its own are. Beyond that by a margin,
// which keeps the plane error of large askew triangles (some 4e-6 of their size) and the origin's
// rounding from putting a surface behind the start; and by up to as much again at random, so that
// where the box is high the origins of one line fall on many lattice points.
std::optional<double> EnvironmentLight::start_ahead(const V3d& foot, const V3d& wi,
                                                    double spread) const {
    double from = -std::numeric_limits<double>::infinity(), to = -from;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = double(sphere_.surfaces.min[axis]) - 0.5 * margin_ - foot[axis];
        const double high = double(sphere_.surfaces.max[axis]) + 0.5 * margin_ - foot[axis];
        if (wi[axis] == 0) {
            if (low > 0 || high < 0) return {};
            continue;
        }
        const double a = low / wi[axis], b = high / wi[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    if (from > to) return {};
    return to + margin_ * (1 + spread);
}

bool EnvironmentLight::sample_emission(const PrimaryPoint& u, EmissionSample& sample) const {
    SkyDirection sky;
    if (!sample_direction(rounded_pair(u, 2), sky)) return false;
    const V2d d = square_to_concentric_disk(V2d(u[0], u[1]));
    const Frame frame(sky.wi);
    const double radius = double(sphere_.radius);
    const V3d wi(sky.wi);
    const V3d foot = V3d(sphere_.center) + (V3d(frame.s) * d.x + V3d(frame.t) * d.y) * radius;
    // A little beyond the sphere, so that rounding puts no surface behind the origin.
    constexpr double kBeyond = 1.01;
    std::optional<double> ahead = kBeyond * radius;
    if (in_medium()) {
        ahead = std::sqrt(std::max(0.0, 1 - d.length2())) * radius;
    } else if (!sphere_.surfaces.isEmpty()) {
        ahead = start_ahead(foot, wi, u[2]);
    }
    if (!ahead) return false;
    sample.ray = Ray{};
    sample.ray.origin = Vec3(foot + wi * *ahead);
    sample.ray.direction = -sky.wi;
    sample.ray.media = media();
    sample.power = sky.radiance * (kPi * sphere_.radius * sphere_.radius / sky.pdf);
    sample.normal = Vec3(0.0f);
    return !is_black(sample.power);
}

bool EnvironmentLight::sample_direct(const Vec3& /*p*/, const Vec3& /*n*/, const Vec2& u,
                                     DirectSample& sample) const {
    SkyDirection sky;
    sample.pdf = 0;
    if (!sample_direction(u, sky)) return false;
    sample = {sky.wi,   std::numeric_limits<float>::infinity(), Vec3(0.0f), sky.radiance, sky.pdf,
              sky.delta};
    return true;
}

bool EnvironmentLight::emission_coordinates(const Vec3& p, const DirectSample& sample,
                                            PrimaryPoint& u) const {
    Vec2 direction = rounded_pair(u, 2);
    SkyDirection sky;
    if (!direction_coordinates(sample.wi, direction)) return false;
    // The start is found for the direction of the rounded coordinates, so that the ray meets p.
    if (!sample_direction(direction, sky) || is_black(sky.radiance)) return false;
    const Frame frame(sky.wi);
    const V3d offset = (V3d(p) - V3d(sphere_.center)) / double(sphere_.radius);
    const V2d on_disk(offset ^ V3d(frame.s), offset ^ V3d(frame.t));
    if (!(on_disk.length2() <= 1)) return false;
    const V2d start = concentric_disk_to_square(on_disk);
    u[0] = start.x, u[1] = start.y;
    set_rounded_pair(u, 2, direction);
    return true;
}

}  // namespace lxs
