// What the engine asks of a host's camera, sampler and film.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "aips/adapter/layers.h"
#include "aips/adapter/scene.h"

namespace aips {

/// Film position in pixels (y down) and lens position in [0,1)^2.
struct CameraSample {
    Vec2 film;
    Vec2 lens;
};

/// A camera ray with the size of its pixel's footprint.
struct CameraRay {
    Ray ray;
    float width = 0;               ///< radius of the footprint at the origin, scene units
    float spread = 0;              ///< its growth per unit of distance
    float depth = 0;               ///< of the origin, scene units: what a layer of depths shows
    float depth_per_distance = 1;  ///< its growth along the ray

    float depth_at(float distance) const { return depth + depth_per_distance * distance; }
};

class Camera {
  public:
    virtual ~Camera() = default;
    virtual CameraRay generate(const CameraSample& sample, float time) const = 0;
    virtual float shutter_open() const = 0;
    virtual float shutter_close() const = 0;
};

class Sampler {
  public:
    virtual ~Sampler() = default;
    /// Sample number `number` of pixel (x, y), a pure function of its arguments. Over numbers the
    /// film position is uniform in the pixel's square.
    virtual CameraSample camera_sample(std::uint64_t number, std::uint32_t x,
                                       std::uint32_t y) const = 0;
};

/// Light with film positions of its own, whose density is divided out already.
struct FilmSplats {
    std::span<const Vec2> positions;  ///< pixels
    /// Radiance of splat i in light group g at [i * groups + g], over the splats' density per
    /// pixel's area: as many as there are pixels, of radiance L and spread evenly, are an image L.
    std::span<const Rgb> radiance;
};

/// What a pass brings to the film, in up to three parts: the image is the sum of a mean over passes
/// of each. Eye paths and splats of all passes count alike, photons by weights that are fixed
/// before the pass: less while a guide learns.
struct FilmPass {
    std::span<const Vec2> positions;  ///< of the samples, pixels
    std::uint32_t groups = 1;         ///< light groups
    /// Radiance that sample i sees without photons in light group g, at [i * groups + g].
    std::span<const Rgb> eye;
    /// What photons bring it, laid out as `eye`; empty in all passes of a scene that needs none.
    std::span<const Rgb> photons = {};
    double photon_weight = 1;  ///< of the pass in the mean of `photons`, > 0
    /// In all passes or in none, and only if the film takes them; a pass may bring no splat.
    std::optional<FilmSplats> splats = {};
};

/// What photons bring the samples of a pass, all light groups together, from their whole search
/// discs and from the inner half of their area; of media, from the sections of their beams. Light
/// that changes evenly is blurred in proportion to the area, so that the difference is half of the
/// bias.
struct BiasSamples {
    std::span<const Vec2> positions;  ///< of the samples, pixels
    std::span<const Rgb> whole, half;
    double weight = 1;  ///< as FilmPass::photon_weight
};

class Film {
  public:
    virtual ~Film() = default;
    virtual std::uint32_t width() const = 0;
    virtual std::uint32_t height() const = 0;
    virtual void add_pass(const FilmPass& pass) = 0;
    /// Whether passes may bring splats. Without them emitters behind glass and in mirrors are met
    /// by eye paths alone.
    virtual bool takes_splats() const { return false; }
    /// Layers that it takes beside what the settings ask for; never change.
    virtual LayersWanted layers_wanted() const { return {}; }
    /// Adds the parts of the image that a pass brought, the image being their sum up to rounding:
    /// as add_pass, with an ImagePart where that has a light group.
    virtual void add_parts(const FilmPass& /*parts*/) {}
    /// Adds what the eye paths of a pass saw of surfaces: `surfaces[i]` at `positions[i]`. All
    /// passes count alike.
    virtual void add_surfaces(std::span<const Vec2> /*positions*/,
                              std::span<const SeenSurface> /*surfaces*/) {}
    /// Adds what the radius does to the photons' part of a pass.
    virtual void add_bias(const BiasSamples& /*samples*/) {}
    /// Adds a pass of the extra colour layer `name`: `values[i]` at `positions[i]`, filtered as the
    /// image is; `weight` > 0 is the pass's share in the mean over passes.
    virtual void add_layer_pass(std::string_view name, std::span<const Vec2> positions,
                                std::span<const Rgb> values, double weight) = 0;
    /// Replaces the extra float layer `name`: width * height values, row by row.
    virtual void set_layer(std::string_view name, std::span<const float> values) = 0;
};

/// Where the engine's messages go.
class Log {
  public:
    virtual ~Log() = default;
    virtual void info(std::string_view message) = 0;
    virtual void warning(std::string_view message) = 0;
};

}  // namespace aips
