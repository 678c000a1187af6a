// Material "glossy_lossy" (old names "substrate" and "plastic"): LuxRender's first glossy material,
// which loses light at grazing angles.
#include "bsdfs/fresnel_blend_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "surface_coating.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

class LossyMaterial final : public Material {
  public:
    LossyMaterial(const ParameterReader& reader, const AssetContext& assets)
        : kd_(read_reflectance(reader, assets, "Kd", Rgb(1.0f))), coating_(reader, assets) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        return place_bsdf<FresnelBlendBsdf>(memory, kd_.at(point.texture),
                                            coating_.coating_at(point.texture),
                                            coating_.facets_at(point));
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.lobes = kDiffuse | kGlossy;
        kd_.add_to(facts);
        coating_.add_to(facts);
        facts.max_bsdf_bytes = kBsdfBytes<FresnelBlendBsdf>;
        return facts;
    }

  private:
    PreparedColor kd_;
    SurfaceCoating coating_;
};

}  // namespace

MaterialFactory glossy_lossy_plugin() {
    std::vector<ParameterDeclaration> own = coating_parameters();
    for (ParameterDeclaration& parameter : own)
        parameter.no_effect |= parameter.name == "multibounce";
    own.push_back(coated_base_parameter());
    return {with_common_parameters(std::move(own)),
            [](const ParameterReader& reader, const AssetContext& assets,
               const Matrix&) -> std::shared_ptr<const Material> {
                warn_of_common_parameters(reader);
                return std::make_shared<LossyMaterial>(reader, assets);
            }};
}

}  // namespace lxs::shading
