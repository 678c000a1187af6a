// Bump and normal maps: a decorator around any material.
// Source: Blinn 1978, "Simulation of Wrinkled Surfaces".
#pragma once

#include "lxs/scene/registry.h"

namespace lxs::shading {

/// Unit normal of the surface displaced by `height` (scene units) along its shading normal: the
/// slope comes from central differences over `step` (scene units), normal maps add theirs. Always
/// in the hemisphere of point.ng. What is not finite is counted for the texture `name`, and leaves
/// the normal as it is.
Vec3 bumped_normal(const FloatTexture& height, float step, const ShadingPoint& point,
                   std::string_view name = {});

/// Declarations of "bumpmap" and the step of its slope.
std::vector<ParameterDeclaration> bump_map_parameters();

/// The factory with its materials wrapped where a scene gives them a bump map.
MaterialFactory with_bump_map(MaterialFactory factory);

}  // namespace lxs::shading
