// The mock host's scene: analytic quads and spheres, lights on them, all in memory.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "aips/adapter/scene.h"
#include "mock_bsdf.h"
#include "mock_media.h"
#include "mock_shapes.h"

namespace mock {

/// A shape, what it is made of, and what it emits from its front.
struct Surface {
    Shape shape;
    Material material;
    aips::Rgb emitted{0, 0, 0};
    aips::Vec3 normal_tilt{0, 0, 0};  ///< added to the shading normal (breaks it on purpose)
    std::uint32_t light_group = 0;
};

/// Directions from which a light at infinity shines.
struct DistantCone {
    aips::Vec3 axis{0, 0, 1};  ///< unit, towards the light
    float cos_half_angle = -1;
};

/// A small scene. Surfaces and lights are added first, then `finish` is called once.
class Scene final : public aips::Scene {
  public:
    void add(Surface surface) { surfaces_.push_back(surface); }
    /// Isotropic point light of `intensity` watts per steradian.
    void add_point_light(aips::Vec3 position, aips::Rgb intensity);
    /// Constant radiance from all around.
    void add_environment(aips::Rgb radiance) { add_distant_light({}, radiance); }
    /// Constant radiance from a cone at infinity. Comes after the surfaces that it lights.
    void add_distant_light(const DistantCone& cone, aips::Rgb radiance);
    /// The six inner walls of the box [lower, upper], all alike.
    void add_box(aips::Vec3 lower, aips::Vec3 upper, const Surface& wall);
    /// Fills the scene with fog, up to the ball around its surfaces. The scene must stay where it
    /// is.
    void fill(const Fog& fog);
    void set_light_groups(std::uint32_t groups) { light_groups_ = groups; }
    /// After all that is added; may be called again when more was.
    void finish();

    bool intersect(const aips::Ray& ray, aips::SurfacePoint& point,
                   std::pmr::memory_resource& memory) const override;
    aips::Ray spawn(const aips::SurfacePoint& point, aips::Vec3 direction,
                    float time) const override;
    aips::Rgb visibility(const aips::SurfacePoint& point, const aips::DirectSample& light,
                         float time) const override;
    std::span<const aips::Light* const> lights() const override { return light_pointers_; }
    std::span<const std::string> material_names() const override { return names_; }
    std::uint32_t light_groups() const override { return light_groups_; }
    aips::Bounds bounds() const override { return bounds_; }
    aips::SceneFacts facts() const override;
    const aips::Media* media() const override { return media_.get(); }
    /// visibility() from anywhere.
    aips::Rgb visibility_from(aips::Vec3 from, const aips::DirectSample& light, float time) const;

    /// Called with the time of every ray traced, if set (tests of one time per pass).
    std::function<void(float)> on_ray;

  private:
    bool nearest(const aips::Ray& ray, double t_max, RayTargets::Hit& hit) const;
    float distance_to_end(const aips::Ray& ray) const;

    std::vector<Surface> surfaces_;
    RayTargets targets_;
    double smallest_step_ = 0;  ///< that single-precision positions of this scene can resolve
    std::vector<aips::LightIndex> light_of_surface_;
    std::vector<std::unique_ptr<aips::Light>> lights_;
    std::vector<const aips::Light*> light_pointers_, lights_of_surfaces_;
    std::vector<std::string> names_;
    std::unique_ptr<Media> media_;
    Fog fog_;
    std::uint32_t light_groups_ = 1;
    aips::Bounds bounds_;
};

}  // namespace mock
