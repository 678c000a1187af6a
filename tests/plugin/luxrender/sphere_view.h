// A scene of LuxRender's half without LuxRender: the inside of a matte sphere that glows, seen from
// its centre. Radiance is the same everywhere, emitted / (1 - reflectance).
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "lux_view.h"

namespace aips::luxrender {

class SphereView : public LuxView {
  public:
    static constexpr float kReflectance = 0.5f, kPi = 3.14159265f;
    static constexpr Triple kEmitted{{1, 2, 4}};
    static constexpr unsigned kPixels = 8;  ///< of a side

    float sensitivity(float nm) const override { return std::exp(-(nm - 550) * (nm - 550) / 5000); }
    float shortest_wavelength() const override { return 380; }
    float longest_wavelength() const override { return 720; }
    void set_wavelengths(const Triple& nanometres, const Triple&) override {
        wavelengths.push_back(nanometres);
    }

    void bounds(Triple& lower, Triple& upper) const override {
        lower = {{-1, -1, -1}};
        upper = {{1, 1, 1}};
    }
    unsigned light_groups() const override { return 1; }

    std::size_t surface_bytes() const override { return sizeof(Triple); }
    bool intersect(const ViewRay& ray, void* place, ViewHit& hit) const override {
        intersect_shape(ray, hit);
        *static_cast<Triple*>(place) = hit.geometric_normal;
        hit.shading_normal = hit.geometric_normal;
        hit.transmittance = {{1, 1, 1}};
        hit.emitted = kEmitted;
        hit.light = 0;
        return true;
    }
    bool intersect_shape(const ViewRay& ray, ViewHit& hit) const override {
        const float along = dot(ray.origin, ray.direction);
        const float square = dot(ray.origin, ray.origin);
        hit.distance = -along + std::sqrt(along * along - square + 1);
        for (int i = 0; i < 3; ++i)
            hit.position.v[i] = ray.origin.v[i] + hit.distance * ray.direction.v[i];
        const float size = std::sqrt(dot(hit.position, hit.position));
        for (int i = 0; i < 3; ++i) {
            hit.position.v[i] /= size;
            hit.geometric_normal.v[i] = -hit.position.v[i];
        }
        return true;
    }
    Triple visibility(const Triple&, const Triple&, const void*, float) const override {
        return {{1, 1, 1}};
    }

    unsigned lobes(const void*) const override { return kDiffuseLobe; }
    Triple evaluate(const void* surface, const Triple& light, const Triple& eye,
                    unsigned lobes) const override {
        const Triple& n = *static_cast<const Triple*>(surface);
        const bool seen = (lobes & kDiffuseLobe) && dot(light, n) > 0 && dot(eye, n) > 0;
        const float f = seen ? kReflectance / kPi : 0;
        return {{f, f, f}};
    }
    float pdf(const void* surface, const Triple& wo, const Triple& wi,
              unsigned lobes) const override {
        const Triple& n = *static_cast<const Triple*>(surface);
        const bool goes = (lobes & kDiffuseLobe) && dot(wo, n) > 0 && dot(wi, n) > 0;
        return goes ? dot(wi, n) / kPi : 0;
    }
    bool sample(const void* surface, const Triple&, const float u[3], bool, unsigned lobes,
                ViewScattering& s) const override {
        if (!(lobes & kDiffuseLobe)) return false;
        s.wi = cosine_direction(*static_cast<const Triple*>(surface), u[0], u[1]);
        s.weight = {{kReflectance, kReflectance, kReflectance}};
        s.pdf = dot(s.wi, *static_cast<const Triple*>(surface)) / kPi;
        s.lobe = kDiffuseLobe;
        return s.pdf > 0;
    }

    unsigned light_count() const override { return 1; }
    unsigned light_group(unsigned) const override { return 0; }
    bool light_at_infinity(unsigned) const override { return false; }
    bool light_is_delta(unsigned) const override { return false; }
    bool emit(unsigned, const float place[3], const float direction[3],
              ViewEmission& emission) const override {
        const Triple at = on_sphere(place[0], place[1]);
        emission.ray.origin = at;
        emission.ray.direction = cosine_direction(negative(at), direction[0], direction[1]);
        for (int i = 0; i < 3; ++i)
            emission.power.v[i] = kEmitted.v[i] * kPi * 4 * kPi;
        return true;
    }
    bool sample_direct(unsigned, const Triple& from, const float u[3],
                       ViewDirect& sample) const override {
        sample.end = on_sphere(u[0], u[1]);
        Triple way;
        for (int i = 0; i < 3; ++i)
            way.v[i] = sample.end.v[i] - from.v[i];
        sample.distance = std::sqrt(dot(way, way));
        if (!(sample.distance > 1e-3f)) return false;
        for (int i = 0; i < 3; ++i)
            sample.wi.v[i] = way.v[i] / sample.distance;
        sample.radiance = kEmitted;
        sample.pdf = pdf_direct(0, from, sample.end, negative(sample.end));
        return sample.pdf > 0;
    }
    float pdf_direct(unsigned, const Triple& from, const Triple& at,
                     const Triple& normal) const override {
        Triple way;
        for (int i = 0; i < 3; ++i)
            way.v[i] = at.v[i] - from.v[i];
        const float square = dot(way, way);
        return square * std::sqrt(square) / (4 * kPi * std::fabs(dot(way, normal)));
    }
    float pdf_escaping(unsigned, const Triple&, const Triple&) const override { return 0; }
    Triple escaped(unsigned, const Triple&) const override { return {}; }

    /// A pinhole at the centre that looks up.
    ViewRay camera_ray(const float film[2], const float*, float time) const override {
        ViewRay camera_ray;
        const float x = (film[0] - kPixels * 0.5f) * pixel_size();
        const float y = (film[1] - kPixels * 0.5f) * pixel_size();
        const float size = std::sqrt(x * x + y * y + 1);
        camera_ray.direction = {{x / size, y / size, 1 / size}};
        camera_ray.time = time;
        return camera_ray;
    }
    static constexpr float pixel_size() { return 1.0f / kPixels; }
    float shutter_open() const override { return 0; }
    float shutter_close() const override { return 0; }

    unsigned film_width() const override { return kPixels; }
    unsigned film_height() const override { return kPixels; }
    void add_sample(FilmPart part, const float*, const Triple& radiance, unsigned,
                    double weight) override {
        Part& sum = parts[part];
        for (int i = 0; i < 3; ++i)
            sum.radiance[i] += weight * radiance.v[i];
        sum.weight += weight;
        ++sum.samples;
    }
    void end_film_pass() override { ++film_passes; }

    void info(const std::string&) override {}
    void warning(const std::string& message) override { warnings.push_back(message); }

    struct Part {
        std::array<double, 3> radiance{};
        double weight = 0;
        unsigned samples = 0;
    };
    std::map<FilmPart, Part> parts;
    std::vector<Triple> wavelengths;
    std::vector<std::string> warnings;
    unsigned film_passes = 0;

  private:
    static float dot(const Triple& a, const Triple& b) {
        return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2];
    }
    static Triple negative(const Triple& t) { return {{-t.v[0], -t.v[1], -t.v[2]}}; }
    static Triple on_sphere(float u, float v) {
        const float z = 1 - 2 * u, r = std::sqrt(std::fmax(0.0f, 1 - z * z));
        return {{r * std::cos(2 * kPi * v), r * std::sin(2 * kPi * v), z}};
    }
    /// Malley's method by a point of a sphere that touches the surface.
    static Triple cosine_direction(const Triple& n, float u, float v) {
        const Triple s = on_sphere(u, v);
        Triple d;
        for (int i = 0; i < 3; ++i)
            d.v[i] = n.v[i] + s.v[i];
        const float size = std::sqrt(std::fmax(dot(d, d), 1e-12f));
        for (float& x : d.v)
            x /= size;
        return d;
    }
};

}  // namespace aips::luxrender
