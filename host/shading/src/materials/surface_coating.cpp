// The rough coating of "glossy" and its relatives: parameters.
#include "surface_coating.h"

#include "common_parameters.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
SurfaceCoating::SurfaceCoating(const ParameterReader& reader, const AssetContext& assets,
                               const std::string& prefix, const Rgb& default_ks,
                               float default_roughness)
    : ks_(read_reflectance(reader, assets, prefix + "Ks", default_ks)),
      ka_(read_absorption(reader, assets, prefix + "Ka")),
      index_(read_limited(reader, assets, prefix + "index", 0, 0, kUnlimited)),
      depth_(read_limited(reader, assets, prefix + "d", 0, 0, kUnlimited)),
      surface_(reader, assets, default_roughness, prefix),
      multibounce_(reader.boolean(prefix + "multibounce", false)) {}

Coating SurfaceCoating::coating_at(const TexturePoint& point) const {
    Coating coating;
    coating.reflectance = ks_.at(point);
    if (const float index = index_.at(point); index > 0) {
        const float root = (index - 1) / (index + 1);
        coating.reflectance *= root * root;
    }
    coating.optical_depth = limited(ka_.at(point) * depth_.at(point), 0, kUnlimited);
    coating.multibounce = multibounce_;
    return coating;
}

void SurfaceCoating::add_to(MaterialFacts& facts) const {
    ks_.add_to(facts);
    ka_.add_to(facts);
    facts.reads_image |= index_.reads_image() || depth_.reads_image() || surface_.reads_image();
}

std::vector<ParameterDeclaration> coating_parameters() {
    using enum ParameterType;
    return declarations(
        {{{"Ks", ColorTexture, "1 1 1", "reflectance of the coating at normal incidence, 0 to 1"},
          {"Ka", ColorTexture, "0 0 0", "absorption of the coating per unit of depth, 0 to 1"},
          {"index", FloatTexture, "0",
           "index of the coating; when above 0 its reflectance is multiplied with Ks", 0},
          {"d", FloatTexture, "0", "depth of the coating", 0},
          {"multibounce", Bool, "false",
           "light shadowed by the coating's facets comes out diffusely"}},
         roughness_parameters("0.1")});
}

}  // namespace lxs::shading
