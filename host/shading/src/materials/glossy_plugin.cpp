// Material "glossy": diffuse base, smooth or rough, under a rough coating.
#include "bsdfs/glossy_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "surface_coating.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

/// LuxRender has two classes for this. "separable" ones have a base of their own, which may be
/// rough and is all there is on the back; the others dim their smooth base on both sides.
class GlossyMaterial final : public Material {
  public:
    GlossyMaterial(const ParameterReader& reader, const AssetContext& assets)
        : kd_(read_reflectance(reader, assets, "Kd", Rgb(1.0f))),
          sigma_(read_limited(reader, assets, "sigma", 0, 0, 90)),
          coating_(reader, assets),
          separable_(reader.boolean("separable", true)) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        const OrenNayarShape shape(separable_ ? sigma_.at(point.texture) * kRadiansPerDegree : 0);
        return place_bsdf<GlossyBsdf>(memory, kd_.at(point.texture),
                                      coating_.coating_at(point.texture), coating_.facets_at(point),
                                      separable_ ? CoatedBack::Bare : CoatedBack::Dimmed, shape);
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
    bool separable_;
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
         "and dimmed by the coating on both sides"}};
    return {with_common_parameters(declarations({own, coating_parameters()})), &create_glossy};
}

}  // namespace lxs::shading
