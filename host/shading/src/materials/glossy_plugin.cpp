// Material "glossy" (old names "substrate" and "plastic"): diffuse base under a rough coating.
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "surface_coating.h"

namespace lxs::shading {
namespace {

class GlossyMaterial final : public Material {
  public:
    GlossyMaterial(PreparedColor kd, SurfaceCoating coating)
        : kd_(std::move(kd)), coating_(std::move(coating)) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        return place_bsdf<GlossyBsdf>(memory, kd_.at(point.texture),
                                      coating_.coating_at(point.texture),
                                      coating_.facets_at(point));
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.lobes = kd_.is(Rgb(0.0f)) ? kGlossy : kDiffuse | kGlossy;
        facts.reads_image = kd_.reads_image() || coating_.reads_image();
        facts.max_bsdf_bytes = kBsdfBytes<GlossyBsdf>;
        return facts;
    }

  private:
    PreparedColor kd_;
    SurfaceCoating coating_;
};

std::shared_ptr<const Material> create(const ParameterReader& reader, const AssetContext& assets,
                                       const Matrix&) {
    warn_of_common_parameters(reader, assets);
    return std::make_shared<GlossyMaterial>(read_reflectance(reader, assets, "Kd", Rgb(1.0f)),
                                            SurfaceCoating(reader, assets));
}

}  // namespace

MaterialFactory glossy_plugin() {
    const std::vector<ParameterDeclaration> own{
        {"Kd", ParameterType::ColorTexture, "1 1 1", "diffuse reflectance of the base, 0 to 1"}};
    return {with_common_parameters(joined(own, coating_parameters())), &create};
}

}  // namespace lxs::shading
