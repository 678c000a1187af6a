// The microfacets of rough materials: parameters.
#include "rough_surface.h"

namespace lxs::shading {

RoughSurface::RoughSurface(const ParameterReader& reader, const AssetContext& assets,
                           float fallback, const std::string& prefix)
    : u_(read_limited(reader, assets, prefix + "uroughness", fallback, 0, 1)),
      v_(read_limited(reader, assets, prefix + "vroughness", fallback, 0, 1)) {}

}  // namespace lxs::shading
