// Material "glossycoating": a rough coating over any other material.
#include "bsdfs/coated_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "surface_coating.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

using MaterialPointer = std::shared_ptr<const Material>;

class GlossyCoatingMaterial final : public Material {
  public:
    GlossyCoatingMaterial(MaterialPointer base, SurfaceCoating coating)
        : base_(std::move(base)), coating_(std::move(coating)) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        const Bsdf* base = base_->scatter(point, memory);
        return place_bsdf<CoatedBsdf>(memory, base, coating_.coating_at(point.texture),
                                      coating_.facets_at(point));
    }
    MaterialFacts facts() const override {
        MaterialFacts facts = base_->facts();
        facts.lobes |= kGlossy;
        facts.reads_uv = true;
        coating_.add_to(facts);
        facts.max_bsdf_bytes += kBsdfBytes<CoatedBsdf>;
        return facts;
    }
    Rgb straight_transmittance(const ShadingPoint& point, const Vec3& direction) const override {
        if (!base_->facts().straight) return Rgb(0.0f);
        return base_->straight_transmittance(point, direction) *
               coating_transmission(coating_.coating_at(point.texture), direction.dot(point.ns));
    }

  private:
    MaterialPointer base_;
    SurfaceCoating coating_;
};

MaterialPointer create_glossycoating(const ParameterReader& reader, const AssetContext& assets,
                                     const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<GlossyCoatingMaterial>(
        read_named_material(reader, assets, "basematerial"), SurfaceCoating(reader, assets));
}

}  // namespace

MaterialFactory glossycoating_plugin() {
    const std::vector<ParameterDeclaration> own{
        {"basematerial", ParameterType::String, "", "name of the material under the coating"}};
    return {with_common_parameters(declarations({own, coating_parameters()})),
            &create_glossycoating};
}

}  // namespace lxs::shading
