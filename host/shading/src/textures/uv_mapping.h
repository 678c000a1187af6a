// Placement of two-dimensional textures on surfaces.
#pragma once

#include <vector>

#include "lxs/scene/texture.h"
#include "lxs/sdk/parameters.h"

namespace lxs::shading {

/// s = uscale * u + udelta, t = vscale * v + vdelta.
struct UvMapping {
    Vec2 scale{1.0f, 1.0f};
    Vec2 delta{0.0f, 0.0f};

    Vec2 operator()(const TexturePoint& point) const { return point.uv * scale + delta; }
};

/// Declarations of the mapping's parameters, to be added to a texture's own.
std::vector<ParameterDeclaration> uv_mapping_parameters();

/// Warns, with its place, of a mapping that isn't rendered (all but "uv").
UvMapping read_uv_mapping(const ParameterReader& reader);

}  // namespace lxs::shading
