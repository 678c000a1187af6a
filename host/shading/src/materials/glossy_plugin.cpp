// Material "glossy" (old names "substrate" and "plastic"): diffuse base under a rough coating.
#include "bsdfs/glossy_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "rough_surface.h"

namespace lxs::shading {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();

class GlossyMaterial final : public Material {
  public:
    GlossyMaterial(const ParameterReader& reader, const AssetContext& assets);

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        return place_bsdf<GlossyBsdf>(memory, kd_.at(point.texture), coating_at(point.texture),
                                      surface_.at(point));
    }
    MaterialFacts facts() const override;

  private:
    Coating coating_at(const TexturePoint& point) const;

    PreparedColor kd_, ks_, ka_;
    PreparedFloat index_, depth_;
    RoughSurface surface_;
    bool multibounce_;
};

GlossyMaterial::GlossyMaterial(const ParameterReader& reader, const AssetContext& assets)
    : kd_(read_reflectance(reader, assets, "Kd", Rgb(1.0f))),
      ks_(read_reflectance(reader, assets, "Ks", Rgb(1.0f))),
      ka_(read_positive_color(reader, assets, "Ka", Rgb(0.0f))),
      index_(read_limited(reader, assets, "index", 0, 0, kLargest)),
      depth_(read_limited(reader, assets, "d", 0, 0, kLargest)),
      surface_(reader, assets),
      multibounce_(reader.boolean("multibounce", false)) {}

Coating GlossyMaterial::coating_at(const TexturePoint& point) const {
    Coating coating;
    coating.reflectance = ks_.at(point);
    if (const float index = index_.at(point); index > 0) {
        const float root = (index - 1) / (index + 1);
        coating.reflectance = Rgb(root * root);
    }
    coating.optical_depth = limited(ka_.at(point) * depth_.at(point), 0, kLargest);
    coating.multibounce = multibounce_;
    return coating;
}

MaterialFacts GlossyMaterial::facts() const {
    MaterialFacts facts;
    facts.lobes = kd_.is(Rgb(0.0f)) ? kGlossy : kDiffuse | kGlossy;
    facts.reads_image = kd_.reads_image() || ks_.reads_image() || ka_.reads_image() ||
                        index_.reads_image() || depth_.reads_image() || surface_.reads_image();
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
