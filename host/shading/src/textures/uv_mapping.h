// Placement of two-dimensional textures on surfaces.
#pragma once

#include <vector>

#include "lxs/scene/texture.h"
#include "lxs/sdk/parameters.h"

namespace lxs::shading {

/// Texture coordinates (s, t) of a surface point, from one of LuxRender's four mappings or the
/// polar one, pbrt's spherical one.
class UvMapping {
  public:
    /// Reads the parameters of uv_mapping_parameters(). Mappings by angles stand in the space of
    /// `to_world`, the transform in force where the texture is defined; throws InputError at
    /// "mapping" if they need its inverse and it has none.
    UvMapping(const ParameterReader& reader, const Matrix& to_world);

    Vec2 operator()(const TexturePoint& point) const { return place(point) * scale_ + delta_; }

  private:
    enum class Kind : std::uint8_t { Uv, Spherical, Polar, Cylindrical, Planar };

    Vec2 place(const TexturePoint& point) const;
    /// Angle around z as a share of a turn, in [0, 1).
    float turn(const Vec3& p) const;

    Kind kind_ = Kind::Uv;
    Vec2 scale_, delta_;
    float turn_start_ = 0;
    Vec3 axis_s_{1, 0, 0}, axis_t_{0, 1, 0};
    Imath::M44f to_texture_;
};

/// Declarations of the mapping's parameters, to be added to a texture's own.
std::vector<ParameterDeclaration> uv_mapping_parameters();

}  // namespace lxs::shading
