// The microfacets of rough materials: parameters.
#include "rough_surface.h"

#include <algorithm>
#include <cmath>

namespace lxs::shading {

RoughSurface::RoughSurface(const ParameterReader& reader, const AssetContext& assets,
                           float fallback, const std::string& prefix, Facets facets)
    : u_(read_limited(reader, assets, prefix + "uroughness", fallback, 0, 1)),
      v_(read_limited(reader, assets, prefix + "vroughness", fallback, 0, 1)),
      facets_(facets) {}

float RoughSurface::constant_alpha() const {
    const TexturePoint anywhere{};
    const float u = std::max(u_.at(anywhere), SchlickDistribution::kMinRoughness);
    return std::sqrt(u * std::max(v_.at(anywhere), SchlickDistribution::kMinRoughness));
}

}  // namespace lxs::shading
