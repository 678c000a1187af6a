// The space of a texture: the inverse of the transform in force where it is defined.
#pragma once

#include "lxs/sdk/parameters.h"
#include "lxs/sdk/types.h"

namespace lxs::shading {

/// World to texture space; throws InputError at parameter `name` if `to_world` has no inverse.
Imath::M44f inverse_or_fail(const ParameterReader& reader, std::string_view name,
                            const Matrix& to_world);

}  // namespace lxs::shading
