// The Scene that integrators trace: Embree hierarchies, surface tables, lights.
#pragma once

#include <memory>
#include <vector>

#include "embree_scene.h"
#include "lxs/lights/lights.h"
#include "lxs/scene/contents.h"
#include "lxs/sdk/scene.h"
#include "placement.h"
#include "scene_survey.h"
#include "surface.h"

namespace lxs {

class TracedScene : public Scene {
  public:
    /// Throws InputError for an instance or a light that can't be built.
    TracedScene(SceneContents contents, const AssetResolver& resolve, Diagnostics& diagnostics);

    bool intersect(const Ray& ray, SurfaceHit& hit,
                   std::pmr::memory_resource& memory) const override;
    Rgb transmittance(const Ray& ray) const override;
    std::span<const Light* const> lights() const override { return light_pointers_; }
    std::span<const std::string> light_groups() const override { return contents_.light_groups; }
    std::span<const std::string> material_names() const override {
        return contents_.material_names;
    }
    Bounds bounds() const override { return bounds_; }
    SceneFacts facts() const override { return survey_.facts; }

    /// Most straight surfaces that `transmittance` passes; what lies behind more counts as blocked.
    static constexpr int kMaxStraightSurfaces = 256;

  private:
    /// Where a group of surfaces stands: the world itself or an instance.
    struct Placement {
        const Surface* surfaces = nullptr;
        const InstanceTransform* transform = nullptr;  ///< null for the world
        Matrix world_to_object;
        std::size_t first_light = 0;  ///< into area_lights_

        const Matrix* to_object() const { return transform ? &world_to_object : nullptr; }
    };

    void build_geometry();
    void place_instances();
    void make_all_lights(const AssetResolver& resolve, Diagnostics& diagnostics);
    const Placement& placement_of(const RawHit& raw) const;
    Rgb walk_transmittance(const Ray& ray) const;

    SceneContents contents_;
    SceneSurvey survey_;
    EmbreeDevice device_;
    SurfaceGroup world_surfaces_;
    std::vector<SurfaceGroup> object_surfaces_;  ///< by object
    std::vector<EmbreeScene> object_scenes_;     ///< by object
    EmbreeScene world_scene_;
    std::vector<InstanceTransform> transforms_;  ///< by instance
    std::vector<Placement> placements_;          ///< the world, then the instances
    std::vector<std::unique_ptr<Light>> lights_;
    std::vector<const Light*> light_pointers_;
    std::vector<const AreaLight*> area_lights_;
    Bounds bounds_;
};

}  // namespace lxs
