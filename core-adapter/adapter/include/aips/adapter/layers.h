// Layers beside the image, as a host's film asks for them and the engine fills them.
#pragma once

#include <cstdint>
#include <limits>

#include "aips/core/base/image_part.h"
#include "aips/core/base/rgb.h"
#include "aips/core/base/vector.h"

namespace aips {

/// Which layers a film wants. What it doesn't want is neither worked out nor kept.
struct LayersWanted {
    bool parts = false;     ///< Film::add_parts is to be called with each pass
    bool surfaces = false;  ///< Film::add_surfaces is to be called with each pass
    bool bias = false;      ///< Film::add_bias is to be called with each pass
};

/// Index of no name.
inline constexpr std::uint32_t kNoName = ~std::uint32_t{0};

/// What an eye path saw of surfaces. Those that let everything pass straight and undimmed are none.
struct SeenSurface {
    /// Bsdf::albedo of the first surface that isn't specular alone, times what mirrors and glass on
    /// the way there left of light; black where there is none.
    Rgb albedo;
    /// Shading normal of the first surface, on the side that was seen; zero where there is none.
    Vec3 normal;
    float depth = std::numeric_limits<float>::infinity();  ///< of it (CameraRay::depth_at)
    std::uint32_t object = kNoName, material = kNoName;    ///< of it, as SurfacePoint has them
};

}  // namespace aips
