// The declared parameters of the films.
#pragma once

#include <string_view>
#include <vector>

#include "lxs/sdk/parameters.h"

namespace lxs {

/// All parameters of `plugin`: LuxRender 1.9's fleximage, and for "multiimage" also those of the
/// film of that name in LuxRender 0.x.
std::vector<ParameterDeclaration> film_parameters(std::string_view plugin);

/// Warns, at its place, about each parameter that asks for something this film doesn't do.
void warn_of_ignored_film_parameters(const ParameterReader& reader);

}  // namespace lxs
