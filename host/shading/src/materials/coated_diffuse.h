// A diffuse base under a rough coating, by either of two models: "glossy" and "glossy_lossy".
#pragma once

#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "surface_coating.h"

namespace lxs::shading {

/// `Model` is the Bsdf, made of (Kd, Coating, MicrofacetLobe); its lobes without a base are
/// `kLobesOfBlackBase`.
template <class Model, LobeMask kLobesOfBlackBase>
class CoatedDiffuse final : public Material {
  public:
    CoatedDiffuse(const ParameterReader& reader, const AssetContext& assets)
        : kd_(read_reflectance(reader, assets, "Kd", Rgb(1.0f))), coating_(reader, assets) {}

    static std::shared_ptr<const Material> create(const ParameterReader& reader,
                                                  const AssetContext& assets, const Matrix&) {
        warn_of_common_parameters(reader);
        return std::make_shared<CoatedDiffuse>(reader, assets);
    }

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        return place_bsdf<Model>(memory, kd_.at(point.texture), coating_.coating_at(point.texture),
                                 coating_.facets_at(point));
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.lobes = kd_.is(Rgb(0.0f)) ? kLobesOfBlackBase : kDiffuse | kGlossy;
        kd_.add_to(facts);
        coating_.add_to(facts);
        facts.max_bsdf_bytes = kBsdfBytes<Model>;
        return facts;
    }

  private:
    PreparedColor kd_;
    SurfaceCoating coating_;
};

/// The base's declaration.
inline ParameterDeclaration base_parameter() {
    return {"Kd", ParameterType::ColorTexture, "1 1 1", "diffuse reflectance of the base, 0 to 1"};
}

}  // namespace lxs::shading
