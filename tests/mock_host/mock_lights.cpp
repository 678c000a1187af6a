// Lights of the mock host: each samples photons and directions with densities that agree.
#include "mock_lights.h"

#include "aips/core/sampling/sampling.h"
#include "aips/parts/plain_lights.h"

namespace mock {
namespace {

using namespace aips;

class QuadLight final : public DiffuseAreaLight {
  public:
    QuadLight(const Quad& q, Rgb radiance, std::uint32_t group)
        : DiffuseAreaLight(radiance, length(cross(q.edge_u, q.edge_v)), group),
          quad_(q),
          normal_(normalize(cross(q.edge_u, q.edge_v))) {}

  private:
    SurfaceSample point(Vec2 u) const override {
        return {quad_.corner + quad_.edge_u * u.x + quad_.edge_v * u.y, normal_};
    }
    Vec2 coordinates(Vec3 position) const override {
        const Vec3 p = position - quad_.corner, n = cross(quad_.edge_u, quad_.edge_v);
        const float area2 = length_squared(n);
        return {clamp_to_unit(dot(cross(p, quad_.edge_v), n) / area2),
                clamp_to_unit(dot(cross(quad_.edge_u, p), n) / area2)};
    }
    Quad quad_;
    Vec3 normal_;
};

class BallLight final : public DiffuseAreaLight {
  public:
    BallLight(const Ball& b, Rgb radiance, std::uint32_t group)
        : DiffuseAreaLight(radiance, 4 * kPi * b.radius * b.radius, group), ball_(b) {}

  private:
    SurfaceSample point(Vec2 u) const override {
        const Vec3 d = square_to_uniform_sphere(u);
        return {ball_.center + d * ball_.radius, ball_.inside_out ? -d : d};
    }
    Vec2 coordinates(Vec3 position) const override {
        return uniform_sphere_to_square(normalize(position - ball_.center));
    }
    Ball ball_;
};

/// Constant radiance from a cone of directions at infinity; photons start on a disk beside the
/// sphere around the scene.
class DistantLight final : public Light {
  public:
    DistantLight(const Bounds& bounds, const DistantCone& cone, Rgb radiance)
        : center_(bounds.center()),
          radius_(bounds.diagonal() / 2),
          frame_(cone.axis),
          extent_(1 - cone.cos_half_angle),
          radiance_(radiance) {}
    std::uint32_t group() const override { return 0; }
    float power() const override { return luminance(radiance_) * solid_angle() * disk_area(); }
    bool at_infinity() const override { return true; }
    Rgb escaped(Vec3 direction) const override { return inside(direction) ? radiance_ : Rgb{}; }
    bool emit(const PrimaryPoint& u, Emission& emission) const override {
        const Vec3 d = -towards(rounded_pair(u, 0));
        const Vec2 disk = square_to_concentric_disk(rounded_pair(u, 2));
        const Vec3 offset = Frame(d).to_world({disk.x * radius_, disk.y * radius_, -radius_});
        emission.ray = {center_ + offset, d, 0, nullptr};
        emission.power = radiance_ * (solid_angle() * disk_area());
        return true;
    }
    bool sample_direct(const SurfacePoint&, Vec2 u, DirectSample& sample) const override {
        sample.wi = towards(u);
        sample.distance = std::numeric_limits<float>::infinity();
        sample.radiance = radiance_;
        sample.pdf = 1 / solid_angle();
        return true;
    }
    float pdf_direct(const SurfacePoint&, Vec3 wi, const SurfacePoint*) const override {
        return inside(wi) ? 1 / solid_angle() : 0;
    }
    bool emission_coordinates(const SurfacePoint& point, const DirectSample& sample,
                              PrimaryPoint& u) const override {
        const Vec3 w = frame_.to_local(sample.wi);
        if (!inside(sample.wi)) return false;
        const Vec2 sphere = uniform_sphere_to_square(w);
        const Vec2 direction{clamp_to_unit(sphere.x * 2 / extent_), sphere.y};
        const Vec3 d = -towards(direction);
        const Vec3 offset = Frame(d).to_local((point.position - center_) / radius_);
        const Vec2 disk = concentric_disk_to_square({offset.x, offset.y});
        u = {direction.x, direction.y, disk.x, disk.y};
        return offset.x * offset.x + offset.y * offset.y <= 1;
    }

  private:
    Vec3 towards(Vec2 u) const {
        return frame_.to_world(square_to_uniform_sphere({u.x * extent_ / 2, u.y}));
    }
    bool inside(Vec3 w) const { return 1 - dot(w, frame_.n) <= extent_; }
    float solid_angle() const { return 2 * kPi * extent_; }
    float disk_area() const { return kPi * radius_ * radius_; }

    Vec3 center_;
    float radius_;
    Frame frame_;
    float extent_;  // 1 - cosine of the half angle
    Rgb radiance_;
};

}  // namespace

std::unique_ptr<aips::Light> make_quad_light(const Quad& quad, aips::Rgb radiance,
                                             std::uint32_t group) {
    return std::make_unique<QuadLight>(quad, radiance, group);
}
std::unique_ptr<aips::Light> make_ball_light(const Ball& ball, aips::Rgb radiance,
                                             std::uint32_t group) {
    return std::make_unique<BallLight>(ball, radiance, group);
}
std::unique_ptr<aips::Light> make_point_light(aips::Vec3 position, aips::Rgb intensity) {
    return std::make_unique<PointLight>(position, intensity);
}
std::unique_ptr<aips::Light> make_distant_light(const aips::Bounds& bounds, const DistantCone& cone,
                                                aips::Rgb radiance) {
    return std::make_unique<DistantLight>(bounds, cone, radiance);
}

}  // namespace mock
