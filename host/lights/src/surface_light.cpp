// Base of area lights: emission and direct sampling by area, given points on the surface.
#include "surface_light.h"

#include <cmath>

#include "lxs/sdk/offset_origin.h"
#include "warp.h"

namespace lxs {

Vec3 segment_end(const SurfacePoint& s, const Vec3& wi, float distance) {
    // Rounding of a direction's coordinates displaces its end by a share of the distance; so does
    // the kernel's, which takes the surface relative to the ray's origin.
    const Vec3 error = s.p_error + Vec3(rounding_bound(8) * distance);
    return offset_origin(s.p, error, s.n, -wi);
}

SurfaceLight::SurfaceLight(const Primitive& primitive, const AreaEmission& emission,
                           const Matrix& object_to_world)
    : AreaLight({.group = emission.group, .hidden = emission.hidden}),
      radiance_(emission.radiance, emission.radiance_texture,
                primitive.to_world * object_to_world) {
    if (emission.profile) profile_.emplace(emission.profile, primitive.to_world * object_to_world);
}

void SurfaceLight::set_emission(const AreaEmission& emission, double area) {
    has_area_ = area > 0 && std::isfinite(area) && static_cast<float>(1 / area) > 0 &&
                std::isfinite(static_cast<float>(1 / area));
    if (!has_area_) return radiance_.scale_by(0);
    const double emitting = kPi * area;
    float luminance_mean = mean_luminance(area);
    if (emission.power > 0 && emission.efficacy > 0 && luminance_mean > 0) {
        // Colours are photometric: a luminance of 1 is 1 cd m^-2, so lumens need no conversion.
        const double lumens = double(emission.power) * emission.efficacy * emission.gain;
        const float factor = static_cast<float>(lumens / (emitting * luminance_mean));
        radiance_.scale_by(factor);
        luminance_mean *= factor;
    } else {
        radiance_.scale_by(emission.gain);
        luminance_mean *= emission.gain;
    }
    power_ = static_cast<float>(emitting * luminance_mean);
}

float SurfaceLight::mean_luminance(double area) const {
    const Rgb share = profile_ ? profile_->flux() / kPi : Rgb(1.0f);
    if (radiance_.is_constant())
        return luminance(radiance_.at(Vec3(0.0f), Vec3(0.0f), Vec2(0.0f)) * share);
    // Importance-corrected mean over a grid: the estimate only steers the choice of lights, except
    // with power and efficacy, where LuxRender too takes a mean of the texture.
    constexpr std::size_t kGrid = 32;
    double sum = 0;
    for (std::size_t i = 0; i < kGrid * kGrid; ++i) {
        const SurfacePoint s = sample_surface(grid_center(i, kGrid));
        if (s.density > 0)
            sum += luminance(radiance_.at(s.p, s.n, s.uv) * share) / (s.density * area);
    }
    return static_cast<float>(sum / (kGrid * kGrid));
}

bool SurfaceLight::emit(const SurfacePoint& s, const Vec2& u, Vec3& direction, Rgb& power) const {
    if (profile_) {
        const float density = profile_->sample(s.n, u, direction);
        if (!(density > 0)) return false;
        power = emitted(s, direction) * ((s.n ^ direction) / density / s.density);
        return true;
    }
    direction = Frame(s.n).to_world(square_to_cosine_hemisphere(u));
    // Le cos / (density * cos / pi): the cosine cancels.
    power = emitted(s, direction) * (kPi / s.density);
    return true;
}

bool SurfaceLight::sample_emission(const PrimaryPoint& u, EmissionSample& sample) const {
    const SurfacePoint s = sample_surface(rounded_pair(u, 0));
    Vec3 direction(0.0f);
    if (!(s.density > 0) || !emit(s, rounded_pair(u, 2), direction, sample.power)) return false;
    sample.normal = s.n;
    sample.ray = Ray{};
    sample.ray.origin = offset_origin(s.p, s.p_error, s.n, direction);
    sample.ray.direction = direction;
    sample.ray.media = media();
    return !is_black(sample.power);
}

bool SurfaceLight::sample_direct(const Vec3& p, const Vec3& /*n*/, const Vec2& u,
                                 DirectSample& sample) const {
    const SurfacePoint s = sample_surface(u);
    const Vec3 to_light = s.p - p;
    const float distance2 = to_light.length2();
    sample.pdf = 0;
    if (!(s.density > 0) || !(distance2 > 0)) return false;
    const float distance = std::sqrt(distance2);
    const Vec3 wi = to_light / distance;
    const float cosine = -(s.n ^ wi);
    if (!(cosine > 0)) return false;
    const float pdf = distance2 * s.density / cosine;
    if (!(pdf > 0) || !std::isfinite(pdf)) return false;
    sample = {wi, distance, segment_end(s, wi, distance), emitted(s, -wi), pdf, false, s.primitive};
    return true;
}

bool SurfaceLight::emission_coordinates(const Vec3& p, const DirectSample& sample,
                                        PrimaryPoint& u) const {
    Vec2 position;
    if (!surface_coordinates(sample.segment_end, sample.primitive, position)) return false;
    // Aimed from where the rounded coordinates lead, the ray still goes through p.
    const SurfacePoint s = sample_surface(position);
    const Vec3 direction = (p - s.p).normalized();
    if (!(s.density > 0) || !((direction ^ s.n) > 0) || is_black(emitted(s, direction)))
        return false;
    Vec2 d;
    if (!profile_) {
        d = cosine_hemisphere_to_square(Frame(s.n).to_local(direction));
    } else if (!profile_->coordinates(s.n, direction, d)) {
        return false;
    }
    set_rounded_pair(u, 0, position);
    set_rounded_pair(u, 2, d);
    return true;
}

float SurfaceLight::pdf_direct(const Vec3& p, const Vec3& /*n*/, const Vec3& wi,
                               const Vec3& light_p, const Vec3& light_n,
                               std::uint32_t primitive) const {
    const float cosine = -(light_n ^ wi);
    if (!(cosine > 0)) return 0;
    const float pdf = (light_p - p).length2() * area_density(light_p, primitive) / cosine;
    return std::isfinite(pdf) ? pdf : 0;
}

Rgb SurfaceLight::radiance(const Vec3& p, const Vec3& n, const Vec2& uv, const Vec3& wo) const {
    return (n ^ wo) > 0 ? shaped(radiance_.at(p, n, uv), n, wo) : Rgb(0.0f);
}

}  // namespace lxs
