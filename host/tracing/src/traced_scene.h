// The Scene that integrators trace: Embree hierarchies, surface tables, lights.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "embree_scene.h"
#include "lxs/lights/lights.h"
#include "lxs/scene/contents.h"
#include "lxs/scene/refused_values.h"
#include "lxs/tracing/trace_scene.h"
#include "media_review.h"
#include "media_table.h"
#include "placement.h"
#include "scene_survey.h"
#include "spectral_lamps.h"
#include "spectral_light.h"
#include "spectral_media.h"
#include "surface.h"

namespace lxs {

/// The times of all keys of moving instances; empty (end below begin) if nothing moves.
struct TimeSpan {
    double begin = std::numeric_limits<double>::infinity();
    double end = -std::numeric_limits<double>::infinity();
};

class TracedScene : public TraceScene {
  public:
    /// Throws InputError for an instance or a light that can't be built.
    TracedScene(SceneContents contents, const AssetResolver& resolve, Diagnostics& diagnostics);

    bool intersect(const Ray& ray, SurfaceHit& hit,
                   std::pmr::memory_resource& memory) const override {
        RawHit raw;
        return find(ray, raw, hit) && complete(ray, raw, hit, memory);
    }
    bool intersect_specular(const Ray& ray, SurfaceHit& hit,
                            std::pmr::memory_resource& memory) const override;
    bool intersect_shape(const Ray& ray, SurfaceHit& hit,
                         std::pmr::memory_resource& memory) const override;
    Rgb transmittance(const Ray& ray) const override;
    std::span<const Light* const> lights() const override { return light_pointers_; }
    std::span<const std::string> light_groups() const override { return contents_.light_groups; }
    std::span<const std::string> material_names() const override {
        return contents_.material_names;
    }
    std::span<const std::string> object_names() const override { return object_names_.names(); }
    void set_wavelengths(const Wavelengths& wavelengths) override;
    const SpectralNeed& spectral_need() const override { return spectral_need_; }
    WavelengthDensity wavelength_density() const override;
    InvalidSampleList refused_values() const override;
    std::span<const SourceLocation> light_places() const override { return light_places_; }
    const EnteredMedia& camera_media() const override { return camera_media_; }
    std::vector<std::string> media_notes() const override;
    void state(StateArchive& archive) override;
    Bounds bounds() const override { return bounds_; }
    SceneFacts facts() const override { return survey_.facts; }
    const Medium* medium(const EnteredMedia& media) const override {
        return media_.medium(media.innermost());
    }

    /// Most straight surfaces that `transmittance` passes; what lies behind more counts as blocked.
    static constexpr int kMaxStraightSurfaces = 256;

  private:
    /// Where a group of surfaces stands: the world itself or an instance.
    struct Placement {
        const Surface* surfaces = nullptr;
        const InstanceTransform* transform = nullptr;  ///< null for the world and if it moves
        const MovingPlacement* moving = nullptr;
        Matrix world_to_object;              ///< of what moves: where its statement says it stands
        std::uint32_t first_light = 0;       ///< into area_lights_
        std::uint32_t object = kOwnObjects;  ///< of all surfaces, for masks; else each has its own
        static constexpr std::uint32_t kOwnObjects = std::numeric_limits<std::uint32_t>::max();

        const Matrix* to_object() const { return transform || moving ? &world_to_object : nullptr; }
    };

    void build_geometry();
    void place_instances();
    void place_moving(const Instance& instance, std::uint32_t id, const TimeSpan& times,
                      Placement& placement);
    void make_area_lights(Diagnostics& diagnostics);
    /// Points of surfaces that bound media or are of glass.
    void find_boundaries();
    /// Finds where media that vary in space are, and what is the most of them; makes lights of
    /// those that emit.
    void bound_media();
    struct MediumExtent {
        Bounds bounds;         ///< around all places where the medium may be; empty: there are none
        bool endless = false;  ///< no surface bounds it
    };
    MediumExtent extent_of(const SceneMedium& medium) const;
    void make_medium_light(const SceneMedium& medium, const MediumExtent& extent,
                           const FieldJobs& jobs);
    /// In which media the camera stands, and what no surface bounds.
    void find_camera_media(Diagnostics& diagnostics);
    void make_other_lights(const AssetResolver& resolve, Diagnostics& diagnostics);
    /// Of the first light at infinity that has such a declaration.
    MediumNumber declared_at_infinity() const;
    void find_light_media(Diagnostics& diagnostics);
    /// Of a light or the camera that stands in `media`, by the statement at `where`.
    void warn_if_not(MediumNumber declared, const EnteredMedia& media, const SourceLocation& where,
                     Diagnostics& diagnostics) const;
    void warn_of_media(Diagnostics& diagnostics) const;
    std::vector<MediaStart> media_starts() const;
    MeetSurface meet_surface() const;
    void make_spectral_lights();
    const Placement& placement_of(const RawHit& raw) const;
    /// Whether there is a surface, and its distance; else all that `intersect` tells then.
    bool find(const Ray& ray, RawHit& raw, SurfaceHit& hit) const;
    /// All the rest. Returns true.
    bool complete(const Ray& ray, const RawHit& raw, SurfaceHit& hit,
                  std::pmr::memory_resource& memory) const;
    /// The surface that was met; writes position, normals and media of `hit`, and what materials
    /// read of it.
    const Surface& locate_hit(const Ray& ray, RawHit raw, SurfaceHit& hit,
                              ShadingPoint& point) const;
    /// What was crossed over the distance, which both stand in `hit`, does to light.
    void add_crossed(const Ray& ray, SurfaceHit& hit) const;
    Rgb walk_transmittance(const Ray& ray) const;
    Rgb medium_transmittance(const Ray& ray, const Medium* medium, float from, float to) const;

    static constexpr std::size_t kNoMediumLight = std::numeric_limits<std::size_t>::max();

    SceneContents contents_;
    std::unique_ptr<RefusedValues[]> refused_;  ///< by material
    MediaTable media_;
    SceneSurvey survey_;
    EmbreeDevice device_;
    ObjectNames object_names_;
    SurfaceGroup world_surfaces_;
    std::vector<SurfaceGroup> object_surfaces_;  ///< by object
    std::vector<EmbreeScene> object_scenes_;     ///< by object
    EmbreeScene world_scene_;
    std::vector<InstanceTransform> transforms_;  ///< by instance
    std::vector<MovingPlacement> moving_;        ///< those that move, in the same order
    std::vector<Placement> placements_;          ///< the world, then the instances
    std::vector<std::unique_ptr<PlacedLight>> lights_;
    std::vector<MediumNumber> declared_media_;  ///< of the lights
    std::vector<std::size_t> medium_lights_;  ///< by number of the medium, kNoMediumLight for none
    std::vector<std::unique_ptr<SpectralLight>> spectral_lights_;  ///< by light, if asked for
    std::vector<const Light*> light_pointers_;                     ///< what lights() shows
    std::vector<SourceLocation> light_places_;                     ///< by light
    std::vector<const AreaLight*> area_lights_;
    Bounds bounds_;
    std::optional<Wavelengths> wavelengths_;  ///< none: R, G and B
    SpectralMedia spectral_media_;
    SpectralLamps spectral_lamps_;
    SpectralNeed spectral_need_;
    EnteredMedia camera_media_, outside_;  ///< outside_: of what no surface bounds
    std::vector<Vec3> boundaries_;         ///< points on some of what bounds media
    SceneSphere sphere_;  ///< around all surfaces: where media end that no surface bounds
};

}  // namespace lxs
