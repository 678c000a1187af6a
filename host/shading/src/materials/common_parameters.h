// Parameters that every material has.
#pragma once

#include <string>
#include <vector>

#include "lxs/scene/registry.h"
#include "rough_surface.h"

namespace lxs::shading {

/// `own` and then the parameters of all materials: bump map and LuxRender's compositing flags.
std::vector<ParameterDeclaration> with_common_parameters(std::vector<ParameterDeclaration> own);

/// Warns of compositing flags that would change the image.
void warn_of_common_parameters(const ParameterReader& reader);

/// The material that the string parameter `name` names; fails if it is not given.
std::shared_ptr<const Material> read_named_material(const ParameterReader& reader,
                                                    const AssetContext& assets,
                                                    std::string_view name);

/// Roughness along u and v with LuxRender's names and default.
std::vector<ParameterDeclaration> roughness_parameters(std::string_view default_text);

/// The same, and the choice of microfacets.
std::vector<ParameterDeclaration> facet_parameters(std::string_view default_roughness);
/// What it chooses.
RoughSurface::Facets read_facets(const ParameterReader& reader);

}  // namespace lxs::shading
