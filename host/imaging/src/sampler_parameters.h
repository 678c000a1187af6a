// The declared parameters of the samplers.
#pragma once

#include <string>
#include <vector>

#include "lxs/sdk/parameters.h"

namespace lxs {

/// Of the sampler `plugin` where an integrator runs it; for docs.
std::vector<ParameterDeclaration> all_sampler_parameters(const std::string& plugin);

}  // namespace lxs
