// Photons and shadow rays of surfaces and points, with densities that agree.
#include "aips/parts/plain_lights.h"

#include "aips/core/sampling/sampling.h"

namespace aips {

Vec2 rounded_pair(const PrimaryPoint& u, std::size_t first) {
    return {clamp_to_unit(float(u[first])), clamp_to_unit(float(u[first + 1]))};
}

float DiffuseAreaLight::power() const {
    return kPi * area_ * luminance(radiance_);
}

bool DiffuseAreaLight::emit(const PrimaryPoint& u, Emission& emission) const {
    const SurfaceSample s = point(rounded_pair(u, 0));
    const Vec3 d = Frame(s.normal).to_world(square_to_cosine_hemisphere(rounded_pair(u, 2)));
    emission.ray = {s.position + s.normal * lift_, d, 0, nullptr};
    emission.power = radiance_ * (kPi * area_);
    return true;
}

bool DiffuseAreaLight::sample_direct(const SurfacePoint& from, Vec2 u, DirectSample& sample) const {
    const SurfaceSample s = point(u);
    const Vec3 to = s.position - from.position;
    sample.distance = length(to);
    if (!(sample.distance > 0)) return false;
    sample.wi = to / sample.distance;
    sample.pdf = density(s.normal, sample.wi, sample.distance);
    sample.radiance = radiance_;
    return sample.pdf > 0;
}

float DiffuseAreaLight::pdf_direct(const SurfacePoint& from, Vec3 wi,
                                   const SurfacePoint* at) const {
    return at ? density(at->geometric_normal, wi, length(at->position - from.position)) : 0;
}

bool DiffuseAreaLight::emission_coordinates(const SurfacePoint& towards, const DirectSample& sample,
                                            PrimaryPoint& u) const {
    const Vec2 start = coordinates(towards.position + sample.wi * sample.distance);
    // Aimed from where the rounded coordinates lead, the ray still goes through the point.
    const SurfaceSample s = point(start);
    const Vec3 d = Frame(s.normal).to_local(normalize(towards.position - s.position));
    if (!(d.z > 0)) return false;
    const Vec2 direction = cosine_hemisphere_to_square(d);
    u = {start.x, start.y, direction.x, direction.y};
    return true;
}

float DiffuseAreaLight::density(Vec3 normal, Vec3 wi, float distance) const {
    const float cosine = -dot(normal, wi);
    return cosine > 0 ? distance * distance / (cosine * area_) : 0;
}

float PointLight::power() const {
    return 4 * kPi * luminance(intensity_);
}

bool PointLight::emit(const PrimaryPoint& u, Emission& emission) const {
    emission.ray = {position_, square_to_uniform_sphere(rounded_pair(u, 2)), 0, nullptr};
    emission.power = intensity_ * (4 * kPi);
    return true;
}

bool PointLight::sample_direct(const SurfacePoint& from, Vec2, DirectSample& sample) const {
    const Vec3 to = position_ - from.position;
    sample.distance = length(to);
    if (!(sample.distance > 0)) return false;
    sample.wi = to / sample.distance;
    sample.radiance = intensity_ / (sample.distance * sample.distance);
    sample.pdf = 1;
    sample.delta = true;
    return true;
}

bool PointLight::emission_coordinates(const SurfacePoint&, const DirectSample& sample,
                                      PrimaryPoint& u) const {
    const Vec2 direction = uniform_sphere_to_square(-sample.wi);
    u[2] = direction.x, u[3] = direction.y;
    return true;
}

}  // namespace aips
