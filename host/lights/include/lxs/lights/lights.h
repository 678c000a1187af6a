// Makes light sources from what the scene reader found.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lxs/scene/contents.h"
#include "lxs/scene/refused_values.h"
#include "lxs/sdk/light.h"

namespace lxs {

/// Sphere around all surfaces, which lights at infinity emit onto.
struct SceneSphere {
    Vec3 center{0.0f};
    float radius = 1;
    Bounds surfaces{};  ///< box around all of them, within the sphere; empty: not known
};

/// Finds an image file for a light (infinite maps).
using AssetResolver =
    std::function<std::string(const std::string& name, const SourceLocation& where)>;

/// What every light carries besides its emission.
struct LightPlacement {
    std::uint32_t group = 0;  ///< light group, index into the scene's names
    bool hidden = false;      ///< the camera does not see it
};

/// A light of a scene.
class PlacedLight : public Light {
  public:
    std::uint32_t group() const final { return placement_.group; }
    bool hidden_from_camera() const final { return placement_.hidden; }
    /// What emitted light starts in; vacuum, if it is not set.
    const EnteredMedia& media() const { return media_; }
    void set_media(const EnteredMedia& media) { media_ = media; }

  protected:
    explicit PlacedLight(const LightPlacement& placement) : placement_(placement) {}

  private:
    LightPlacement placement_;
    EnteredMedia media_;
};

using Lights = std::vector<std::unique_ptr<PlacedLight>>;

/// Lights without geometry: point, spot, distant, infinite, sun, sky; sunsky gives two. Throws
/// InputError; an unknown name's message lists the known ones.
Lights make_lights(const LightDescription& description, const SceneSphere& sphere,
                   const AssetResolver& resolve, Diagnostics& diagnostics);

/// The intensities by direction that an area light's statement names; null if it names none, then
/// it is diffuse. Throws InputError for files that can't be read.
std::shared_ptr<const FrontProfile> read_area_profile(const ParameterReader& reader,
                                                      const AssetResolver& resolve);

/// Radiance that an area light sends from its front; the tracer asks it at a hit.
class AreaLight : public PlacedLight {
  public:
    using PlacedLight::PlacedLight;
    /// Whether its shape has an area that is neither zero nor infinite; else it sends no light.
    virtual bool has_area() const = 0;
    /// Radiance leaving point `p` with front normal `n` and texture coordinates `uv` towards `wo`.
    virtual Rgb radiance(const Vec3& p, const Vec3& n, const Vec2& uv, const Vec3& wo) const = 0;
    /// What it emits, up to a factor, if that was given as a spectrum and is the same everywhere;
    /// else null.
    virtual CurvePointer spectrum() const = 0;
    /// Counts values of its texture that were not finite or negative: taken for 0.
    virtual RefusedValues& refused_values() const = 0;
};

/// The light of an emissive shape; `instance_to_world` is the identity outside of instances.
std::unique_ptr<AreaLight> make_area_light(const Primitive& primitive,
                                           const Matrix& instance_to_world);

/// Where a medium that emits is.
struct EmittingVolume {
    std::shared_ptr<const Medium> medium;
    Bounds bounds;  ///< around all of it
    /// Whether a place within them is in the medium; `direction`, unit, is one along which it is
    /// looked for what bounds the medium there.
    std::function<bool(const Vec3& position, const Vec3& direction)> inside;

    /// Radiance that is sent there per unit of distance; black outside of the medium.
    Rgb emission(const Vec3& position, const Vec3& direction) const;
};

/// The light that a medium sends by itself.
std::unique_ptr<PlacedLight> make_medium_light(const LightPlacement& placement,
                                               EmittingVolume volume, const FieldJobs& jobs);

/// Names that make_lights knows, with their declared parameters, for docs and messages.
struct LightPlugin {
    std::string name;
    std::vector<ParameterDeclaration> parameters;
};
const std::vector<LightPlugin>& light_plugins();

/// Declared parameters of AreaLightSource "area"; the reader makes AreaEmission from them.
std::span<const ParameterDeclaration> area_light_parameters();

}  // namespace lxs
