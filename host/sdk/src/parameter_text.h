// Words for declared parameters in help and error messages.
#pragma once

#include <string>
#include <string_view>

#include "lxs/sdk/parameters.h"

namespace lxs {

/// Shortest text that reads back as `value`, independent of the locale.
std::string number_text(double value);

/// How the parameter is written in a scene file, e.g. `"color Kd" [r g b]`.
std::string written_form(const ParameterDeclaration& declaration);

/// Name of a parameter type as scene files and messages use it.
std::string_view type_name(ParameterType type);

/// Range of a number in words ("between 0 and 1", "at least 0"); empty if there is none.
std::string range_text(const ParameterDeclaration& declaration);

}  // namespace lxs
