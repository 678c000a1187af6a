// Placement of three-dimensional textures.
#pragma once

#include <vector>

#include "lxs/scene/texture.h"
#include "lxs/sdk/parameters.h"

namespace lxs::shading {

/// A point's position and unit normal in the space of its shape.
Vec3 local_position(const TexturePoint& point);
Vec3 local_normal(const TexturePoint& point);

/// Position in a texture's own space.
class SpaceMapping {
  public:
    /// Reads the parameters of space_mapping_parameters(). The texture is scaled, turned and
    /// moved by them, then placed by `to_world`, the transform in force where it is defined.
    /// Throws InputError if that cannot be inverted.
    SpaceMapping(const ParameterReader& reader, const Matrix& to_world);

    Vec3 operator()(const TexturePoint& point) const;
    /// Least length in world space of steps along the axes of the texture's space; 0 where it is
    /// not placed in the world.
    float shortest_in_world(const Matrix& steps) const;

  private:
    bool normal_ = false, local_ = false, uv_ = false;
    Imath::M44f to_texture_;
    Matrix normal_to_texture_;
};

/// Declarations of the mapping's parameters, to be added to a texture's own.
std::vector<ParameterDeclaration> space_mapping_parameters();

}  // namespace lxs::shading
