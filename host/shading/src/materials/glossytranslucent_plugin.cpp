// Material "glossytranslucent": translucent sheet under rough coatings.
#include "bsdfs/glossy_translucent_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "surface_coating.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

class GlossyTranslucentMaterial final : public Material {
  public:
    GlossyTranslucentMaterial(const ParameterReader& reader, const AssetContext& assets)
        : kd_(read_reflectance(reader, assets, "Kd", Rgb(1.0f))),
          kt_(read_reflectance(reader, assets, "Kt", Rgb(1.0f))),
          front_(reader, assets),
          back_(back_coating(reader, assets)) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override;
    MaterialFacts facts() const override;

  private:
    /// With "onesided" the back is coated as the front is.
    static SurfaceCoating back_coating(const ParameterReader& reader, const AssetContext& assets) {
        if (reader.boolean("onesided", true)) return {reader, assets};
        return {reader, assets, "backface_", Rgb(0.0f), 0};
    }

    PreparedColor kd_, kt_;
    SurfaceCoating front_, back_;
};

const Bsdf* GlossyTranslucentMaterial::scatter(const ShadingPoint& point,
                                               std::pmr::memory_resource& memory) const {
    const Rgb kd = kd_.at(point.texture);
    const GlossyBsdf front(kd, front_.coating_at(point.texture), front_.facets_at(point),
                           CoatedBack::Coated);
    const GlossyBsdf back(kd, back_.coating_at(point.texture), back_.facets_at(point),
                          CoatedBack::Coated);
    return place_bsdf<GlossyTranslucentBsdf>(memory, front, back, kt_.at(point.texture), point.ng,
                                             point.ns);
}

MaterialFacts GlossyTranslucentMaterial::facts() const {
    MaterialFacts facts;
    const bool opaque = kt_.is(Rgb(0.0f));
    facts.lobes = opaque && kd_.is(Rgb(0.0f)) ? kGlossy : kDiffuse | kGlossy;
    facts.transmits = !opaque;
    kd_.add_to(facts);
    kt_.add_to(facts);
    front_.add_to(facts);
    back_.add_to(facts);
    facts.max_bsdf_bytes = kBsdfBytes<GlossyTranslucentBsdf>;
    return facts;
}

std::shared_ptr<const Material> create_glossytranslucent(const ParameterReader& reader,
                                                         const AssetContext& assets,
                                                         const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<GlossyTranslucentMaterial>(reader, assets);
}

}  // namespace

MaterialFactory glossytranslucent_plugin() {
    using enum ParameterType;
    const std::vector<ParameterDeclaration> own{
        {"Kd", ColorTexture, "1 1 1", "diffuse reflectance of the base, 0 to 1"},
        {"Kt", ColorTexture, "1 1 1", "diffuse transmittance of the base, 0 to 1"},
        {"onesided", Bool, "true",
         "the back is coated like the front; else by the backface parameters"},
        {"backface_Ks", ColorTexture, "0 0 0",
         "reflectance of the back's coating at normal incidence, 0 to 1"},
        {"backface_Ka", ColorTexture, "0 0 0", "absorption of the back's coating, 0 to 1"},
        {"backface_index", FloatTexture, "0", "index of the back's coating, as index", 0},
        {"backface_d", FloatTexture, "0", "depth of the back's coating", 0},
        {"backface_multibounce", Bool, "false", "multibounce of the back"},
        {"backface_uroughness", FloatTexture, "0", "roughness of the back along u, 0.006 to 1", 0},
        {"backface_vroughness", FloatTexture, "0", "roughness of the back along v, 0.006 to 1", 0}};
    return {with_common_parameters(declarations({own, coating_parameters()})),
            &create_glossytranslucent};
}

}  // namespace lxs::shading
