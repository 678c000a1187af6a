// The microfacets of rough materials: parameters.
#include "rough_surface.h"

namespace lxs::shading {
namespace {

PreparedFloat read_roughness(const ParameterReader& reader, const AssetContext& assets,
                             std::string_view name, float fallback) {
    const bool old_name =
        !name.starts_with("backface_") && !reader.given(name) && reader.given("roughness");
    return read_limited(reader, assets, old_name ? "roughness" : name, fallback, 0, 1);
}

}  // namespace

RoughSurface::RoughSurface(const ParameterReader& reader, const AssetContext& assets,
                           float fallback, const std::string& prefix)
    : u_(read_roughness(reader, assets, prefix + "uroughness", fallback)),
      v_(read_roughness(reader, assets, prefix + "vroughness", fallback)) {}

}  // namespace lxs::shading
