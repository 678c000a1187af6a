// Material "glossy" (old names "substrate" and "plastic"): diffuse base under a rough coating.
#include "bsdfs/glossy_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "coating_parameters.h"
#include "common_parameters.h"
#include "material_plugins.h"

namespace lxs::shading {
namespace {

class GlossyMaterial final : public Material {
  public:
    GlossyMaterial(const ParameterReader& reader, const AssetContext& assets)
        : kd_(read_reflectance(reader, assets, "Kd", Rgb(1.0f))),
          coating_(reader, assets, "", Rgb(1.0f), reader.boolean("multibounce", false)) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        return place_bsdf<GlossyBsdf>(memory, kd_.at(point.texture), coating_.at(point.texture),
                                      coating_.facets(point));
    }
    MaterialFacts facts() const override;

  private:
    PreparedColor kd_;
    CoatingParameters coating_;
};

MaterialFacts GlossyMaterial::facts() const {
    MaterialFacts facts;
    facts.lobes = kd_.is(Rgb(0.0f)) ? kGlossy : kDiffuse | kGlossy;
    facts.reads_image = kd_.reads_image() || coating_.reads_image();
    facts.max_bsdf_bytes = kBsdfBytes<GlossyBsdf>;
    return facts;
}

std::shared_ptr<const Material> create(const ParameterReader& reader, const AssetContext& assets,
                                       const Matrix&) {
    warn_of_common_parameters(reader, assets);
    return std::make_shared<GlossyMaterial>(reader, assets);
}

}  // namespace

MaterialFactory glossy_plugin() {
    using enum ParameterType;
    const std::vector<ParameterDeclaration> own{
        {"Kd", ColorTexture, "1 1 1", "diffuse reflectance of the base, 0 to 1"},
        {"Ks", ColorTexture, "1 1 1", "reflectance of the coating at normal incidence, 0 to 1"},
        {"Ka", ColorTexture, "0 0 0", "absorption of the coating per unit of depth"},
        {"index", FloatTexture, "0", "index of the coating; overrides Ks when above 0", 0},
        {"d", FloatTexture, "0", "depth of the coating", 0},
        {"multibounce", Bool, "false",
         "light shadowed by the coating's facets comes out diffusely"},
        {"roughness", FloatTexture, "0.1", "old name for both u and v roughness", 0}};
    return {with_common_parameters(joined(own, roughness_parameters("0.1"))), &create};
}

}  // namespace lxs::shading
