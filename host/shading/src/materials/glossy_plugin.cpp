// Material "glossy": diffuse base, smooth or rough, under a rough coating.
#include <array>

#include "bsdfs/glossy_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "surface_coating.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

constexpr std::array<std::string_view, 2> kFresnels{"schlick", "dielectric"};

/// LuxRender has two classes for this. "separable" ones have a base of their own, which may be
/// rough and is all there is on the back; the others dim their smooth base on both sides.
class GlossyMaterial final : public Material {
  public:
    GlossyMaterial(const ParameterReader& reader, const AssetContext& assets)
        : kd_(read_reflectance(reader, assets, "Kd", Rgb(1.0f))),
          sigma_(read_limited(reader, assets, "sigma", 0, 0, 90)),
          coating_(reader, assets),
          back_(reader.boolean("conserving", false) ? CoatedBack::Coated
                : reader.boolean("separable", true) ? CoatedBack::Bare
                                                    : CoatedBack::Dimmed),
          conserving_(reader.boolean("conserving", false)),
          dielectric_(conserving_ && reader.string("fresnel", "schlick") == "dielectric") {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        const bool rough = back_ != CoatedBack::Dimmed;
        const OrenNayarShape shape(rough ? sigma_.at(point.texture) * kRadiansPerDegree : 0);
        Coating coating = coating_.coating_at(point.texture);
        const MicrofacetLobe facets = coating_.facets_at(point);
        // Albedos are tabulated for facets without grain.
        coating.conserving = conserving_ && !facets.grained();
        coating.dielectric = dielectric_ && coating.conserving;
        coating.multibounce |= coating.conserving;
        return place_bsdf<GlossyBsdf>(memory, kd_.at(point.texture), coating, facets, back_, shape);
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.lobes = kd_.is(Rgb(0.0f)) ? kGlossy : kDiffuse | kGlossy;
        facts.reads_image = sigma_.reads_image();
        kd_.add_to(facts);
        coating_.add_to(facts);
        facts.max_bsdf_bytes = kBsdfBytes<GlossyBsdf>;
        return facts;
    }

  private:
    PreparedColor kd_;
    PreparedFloat sigma_;
    SurfaceCoating coating_;
    CoatedBack back_;
    bool conserving_, dielectric_;
};

std::shared_ptr<const Material> create_glossy(const ParameterReader& reader,
                                              const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    if (!reader.boolean("separable", true) && reader.given("sigma")) {
        reader.diagnostics().warning(reader.where("sigma"),
                                     "\"sigma\" has no effect if \"separable\" is false");
    }
    return std::make_shared<GlossyMaterial>(reader, assets);
}

}  // namespace

MaterialFactory glossy_plugin() {
    using enum ParameterType;
    const std::vector<ParameterDeclaration> own{
        coated_base_parameter(),
        {"sigma", FloatTexture, "0",
         "roughness of the base: deviation of its facets' slope in degrees, 0 to 90", 0},
        {"separable", Bool, "true",
         "the base has a roughness of its own, and the back shows it uncoated; else it is smooth "
         "and dimmed by the coating on both sides"},
        {"conserving", Bool, "false",
         "both sides are coated, light that facets shadow comes out, and the base has what the "
         "coating leaves, so that white loses nothing (without grain). Not LuxRender's."},
        choice("fresnel", "schlick",
               "with conserving: how the coating reflects more at grazing angles", kFresnels)};
    return {with_common_parameters(declarations({own, coating_parameters()})), &create_glossy};
}

}  // namespace lxs::shading
