// The microfacets of rough materials: parameters.
#include "rough_surface.h"

namespace lxs::shading {
namespace {

constexpr float kDefaultRoughness = 0.1f;

PreparedFloat read_roughness(const ParameterReader& reader, const AssetContext& assets,
                             std::string_view name) {
    const bool old_name = !reader.given(name) && reader.given("roughness");
    return read_limited(reader, assets, old_name ? "roughness" : name, kDefaultRoughness, 0, 1);
}

}  // namespace

RoughSurface::RoughSurface(const ParameterReader& reader, const AssetContext& assets)
    : u_(read_roughness(reader, assets, "uroughness")),
      v_(read_roughness(reader, assets, "vroughness")) {}

}  // namespace lxs::shading
