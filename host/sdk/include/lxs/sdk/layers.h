// Layers beside the image, as a film asks for them and integrators fill them.
#pragma once

#include <cstdint>
#include <limits>

#include "lxs/sdk/types.h"

namespace lxs {

/// Which layers a film wants. What it doesn't want is neither worked out nor kept.
struct LayersWanted {
    bool direct = false;
    bool indirect = false;
    bool caustics = false;
    bool albedo = false;
    bool normal = false;
    bool depth = false;
    bool objects = false;    ///< masks of them
    bool materials = false;  ///< likewise
    bool alpha = false;      ///< the part of each pixel that surfaces cover
    bool bias = false;       ///< whether Film::add_bias is to be called with each pass

    bool operator==(const LayersWanted&) const = default;
    /// Whether Film::add_parts is to be called with each pass.
    bool parts() const { return direct || indirect || caustics; }
    /// Whether Film::add_surfaces is to be called with each pass.
    bool surfaces() const { return albedo || normal || depth || objects || materials || alpha; }
};

/// Parts that the image is the sum of, by the scatterings of a light path that are diffuse, glossy
/// or in a medium; what passes straight is none.
enum class ImagePart : std::uint8_t {
    Direct,    ///< none, or one that light has reached straight from an emitter
    Caustics,  ///< one that light has reached from an emitter by way of specular surfaces
    Indirect,  ///< two or more
};
inline constexpr std::uint32_t kImageParts = 3;

/// Index of no name.
inline constexpr std::uint32_t kNoName = ~std::uint32_t{0};

/// What one camera sample saw of surfaces. Those that let everything pass straight and undimmed
/// (null materials) are none.
struct SeenSurface {
    /// Reflectance of the first surface that isn't specular alone, times what mirrors and glass on
    /// the way there left of light; black where there is none.
    Rgb albedo{0.0f};
    /// Shading normal of the first surface, unit, world space, on the side that the sample saw;
    /// zero where there is none.
    Vec3 normal{0.0f};
    /// Of the first surface, scene units: along the camera's axis, from environment cameras along
    /// the ray (CameraRay::depth).
    float depth = std::numeric_limits<float>::infinity();
    /// Of the first surface: indices into Scene::object_names() and material_names().
    std::uint32_t object = kNoName, material = kNoName;
};

}  // namespace lxs
