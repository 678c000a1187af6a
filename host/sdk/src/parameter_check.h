// Checks one parameter of a scene file against its declaration.
#pragma once

#include "lxs/sdk/parameters.h"

namespace lxs {

/// True if the value names a texture: a string given where the type is neither string nor bool.
bool is_texture_reference(const ParameterValue& value);

/// Numbers that make up one value of a type.
std::size_t components(ParameterType type);

/// Throws InputError if the type that a value is written with is none.
void check_written_type(const ParameterValue& value);

/// Throws InputError if `value` does not fit `declaration`: type, count, range, choices.
void check_parameter(const ParameterValue& value, const ParameterDeclaration& declaration,
                     const std::string& plugin);

}  // namespace lxs
