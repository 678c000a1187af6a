// Test surfaces: the scene's box for lights at infinity, a sphere around the others.
#include "light_flux.h"

#include "emit_at_random.h"

namespace aips {
namespace {

/// Emissions that tell where a light's photons go (draws).
constexpr std::size_t kFluxPilots = 32;

/// Radius of the sphere around a light's photons' origins: far enough for irradiance to be bounded
/// by a few times its mean (extents of the origins).
constexpr float kSphereExtents = 2.5f;

const Frame kWorldAxes({1, 0, 0}, {0, 1, 0}, {0, 0, 1});

/// A closed box that photons may cross.
struct Box {
    Bounds bounds;

    explicit Box(const Bounds& of) : bounds(of) {
        // Flat scenes get some thickness, or rounding decides whether they are met.
        const float margin = 1e-3f * of.diagonal();
        const Vec3 room{margin, margin, margin};
        bounds = {of.lower - room, of.upper + room};
    }
    bool crossed_by(const Ray& ray) const {
        double t0 = 0, t1 = 1e30;
        for (int axis = 0; axis < 3; ++axis) {
            const double o = ray.origin[axis], d = ray.direction[axis];
            const double a = (bounds.lower[axis] - o) / d, b = (bounds.upper[axis] - o) / d;
            t0 = std::max(t0, std::min(a, b));
            t1 = std::min(t1, std::max(a, b));
        }
        return t0 <= t1;
    }
    double projected_area(Vec3 w) const {
        const Vec3 e = bounds.extent();
        return std::abs(double(w.x) * e.y * e.z) + std::abs(double(w.y) * e.z * e.x) +
               std::abs(double(w.z) * e.x * e.y);
    }
};

struct Sphere {
    Vec3 center;
    float radius = 1;

    /// Unit direction from the centre of where a ray from within leaves it.
    Vec3 exit(const Ray& ray) const {
        const Vec3 o = ray.origin - center;
        const float b = dot(o, ray.direction);
        const float disc = b * b - length_squared(o) + radius * radius;
        return normalize(o + ray.direction * (-b + std::sqrt(std::max(0.0f, disc))));
    }
};

class Measurement {
  public:
    Measurement(const Scene& scene, const Light& light, std::uint32_t samples, RandomStream& random)
        : light_(light),
          samples_(samples),
          random_(random),
          box_(scene.bounds()),
          far_(light.at_infinity() || is_parallel()) {}

    LightFlux measure() {
        if (!far_) find_sphere();
        std::vector<Vec3> pilots;
        for (std::size_t i = 0; i < kFluxPilots; ++i) {
            Emission e;
            if (!emit_at_random(light_, random_, e) || !sound(e)) continue;
            pilots.push_back(far_ ? -e.ray.direction : sphere_.exit(e.ray));
        }
        for (std::uint32_t i = 0; i < samples_; ++i)
            add_photon();
        const DirectionProposal q(std::move(pilots));
        for (std::uint32_t i = 0; i < samples_; ++i) {
            if (!far_) {
                add_sphere_point(q);
            } else if (light_.at_infinity()) {
                add_direction(q);
            } else {
                add_parallel();
            }
        }
        return flux_;
    }

  private:
    bool sound(const Emission& e) {
        return flux_.values.look(
            is_valid_radiance(e.power) && is_finite(e.ray.origin) && is_finite(e.ray.direction) &&
                std::abs(length_squared(e.ray.direction) - 1) < 1e-3f,
            [&] {
                return "a photon of power " + figure(luminance(e.power)) +
                       ", direction of length " + figure(length(e.ray.direction));
            });
    }

    void find_sphere() {
        Bounds origins;
        for (int i = 0; i < 256; ++i) {
            Emission e;
            if (emit_at_random(light_, random_, e) && sound(e)) origins.extend(e.ray.origin);
        }
        if (origins.empty()) return;
        const float extent = 0.5f * origins.diagonal();
        const Vec3 reach = max(abs(origins.lower), abs(origins.upper));
        const float far = std::max({reach.x, reach.y, reach.z, 1e-6f});
        // A point's sphere is wide enough for coordinates to resolve it.
        sphere_ = {origins.center(), std::max(kSphereExtents * extent, 1e-2f * far)};
    }

    void add_photon() {
        Emission e;
        const bool emitted = emit_at_random(light_, random_, e) && sound(e);
        const double power = emitted ? double(luminance(e.power)) : 0;
        flux_.emitted.add(power);
        int there = -1;
        if (emitted && far_) {
            if (box_.crossed_by(e.ray)) there = octant(kWorldAxes, -e.ray.direction);
        } else if (emitted) {
            there = octant(kWorldAxes, sphere_.exit(e.ray));
        }
        add(flux_.by_photons, there, there >= 0 ? power : 0);
    }

    bool direct(const SurfacePoint& from, DirectSample& sample) {
        const Vec2 u = random_.next2();
        return light_.sample_direct(from, u, sample) &&
               flux_.values.look(is_valid_radiance(sample.radiance) && sample.pdf > 0 &&
                                     std::isfinite(sample.pdf) && is_finite(sample.wi),
                                 [&] {
                                     return "a direct sample of radiance " +
                                            figure(luminance(sample.radiance)) + ", pdf " +
                                            figure(sample.pdf);
                                 });
    }

    SurfacePoint point_at(Vec3 position, Vec3 normal) const {
        SurfacePoint point;
        point.position = position;
        point.geometric_normal = point.shading_normal = normal;
        return point;
    }

    void add_sphere_point(const DirectionProposal& q) {
        const Vec3 x = q.sample(random_);
        DirectSample s;
        double value = 0;
        if (direct(point_at(sphere_.center + x * sphere_.radius, -x), s)) {
            const double area = double(sphere_.radius) * sphere_.radius;
            value = double(luminance(s.radiance)) * std::max(0.0f, -dot(s.wi, x)) * area /
                    (s.pdf * q.pdf(x));
        }
        add(flux_.by_points, octant(kWorldAxes, x), value);
    }

    void add_direction(const DirectionProposal& q) {
        const Vec3 w = q.sample(random_);
        const Rgb seen = light_.escaped(w);
        const bool valid = flux_.values.look(
            is_valid_radiance(seen), [&] { return "escaped() " + figure(luminance(seen)); });
        const double value =
            valid ? double(luminance(seen)) * box_.projected_area(w) / q.pdf(w) : 0;
        add(flux_.by_points, octant(kWorldAxes, w), value);
    }

    /// Light of one direction, which no ray meets.
    bool is_parallel() {
        DirectSample s;
        return light_.sample_direct(point_at(box_.bounds.center(), {0, 0, 1}), {0.5f, 0.5f}, s) &&
               s.delta && std::isinf(s.distance);
    }
    void add_parallel() {
        DirectSample s;
        if (!direct(point_at(box_.bounds.center(), {0, 0, 1}), s)) return;
        add(flux_.by_points, octant(kWorldAxes, s.wi),
            double(luminance(s.radiance)) * box_.projected_area(s.wi) / s.pdf);
    }

    const Light& light_;
    std::uint32_t samples_;
    RandomStream& random_;
    Box box_;
    bool far_;  ///< comes from beyond the scene
    Sphere sphere_;
    LightFlux flux_;
};

}  // namespace

LightFlux measure_flux(const Scene& scene, const Light& light, std::uint32_t samples,
                       RandomStream& random) {
    return Measurement(scene, light, samples, random).measure();
}

}  // namespace aips
