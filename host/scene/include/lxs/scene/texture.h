// Textures: functions of a surface point.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>

// First, or g++ 12 calls the enumerators of ParameterType shadows of the aliases below.
#include "lxs/sdk/parameters.h"
#include "lxs/sdk/types.h"
#include "lxs/spectrum/spectral_curve.h"

namespace lxs {

class RefusedValues;

/// What a colour is wanted for: a flat spectrum is white as a reflectance, but not as a light.
enum class ColourUse : std::uint8_t { Surface, Light };

/// The part of a surface point that textures read.
struct TexturePoint {
    Vec3 p{0.0f};  ///< world space
    Vec3 n{0.0f};  ///< shading normal
    Vec2 uv{0.0f};
    const Wavelengths* wavelengths = nullptr;  ///< of the pass; null where Rgb means R, G and B
    Rgb color{1.0f};  ///< of the mesh's vertices, interpolated; white where it has none
    float alpha = 1;  ///< likewise, opacity
    ColourUse use = ColourUse::Surface;
    std::uint32_t face = 0;  ///< tells faces of meshes and whole quadrics apart, in no order
    /// World to object space (null in the world itself), then on to the space of the shape, where
    /// textures with "local" coordinates lie; null where unknown.
    const Matrix* world_to_object = nullptr;
    const Matrix* object_to_shape = nullptr;
    RefusedValues* refused = nullptr;  ///< counts values that no material can use; may be null
};

/// The smaller of two sizes of cells, of which 0 stands for none.
inline float smaller_cell(float a, float b) {
    return a > 0 && b > 0 ? std::min(a, b) : std::max(a, b);
}

/// A texture with values of type T (float, Rgb).
template <class T>
class Texture {
  public:
    virtual ~Texture() = default;
    virtual T evaluate(const TexturePoint& point) const = 0;
    /// The value if it is the same everywhere (ColourUse::Surface): materials prepare for it once.
    virtual std::optional<T> constant() const { return std::nullopt; }
    /// For a colour that was given as a spectrum and is the same everywhere: that spectrum, of
    /// which the values are colours. Else null; where wavelengths are rendered, a smooth spectrum
    /// stands for the colour then.
    virtual CurvePointer spectrum() const { return nullptr; }
    /// For a float texture that is taken as a height: the slope that normal maps add to that of the
    /// value, height per length along the two unit tangents of a surface (u, then v).
    virtual Vec2 mapped_slope(const TexturePoint& /*point*/) const { return Vec2(0.0f); }
    /// True if an image file is read.
    virtual bool reads_image() const { return false; }
    /// Of what is made of cells in space, the least side of a cell in world space; 0: of no cells.
    virtual float cell_size() const { return 0; }
};

/// Complex index of refraction per RGB channel.
struct FresnelValue {
    Rgb eta{1.5f};
    Rgb k{0.0f};
    bool conductor = false;
};

using FloatTexture = Texture<float>;
using ColorTexture = Texture<Rgb>;
using FresnelTexture = Texture<FresnelValue>;

}  // namespace lxs
