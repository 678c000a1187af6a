// Material "velvet": a thin layer of fibres on black.
#include "bsdfs/asperity_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "prepared_texture.h"

namespace lxs::shading {
namespace {

constexpr float kLargestCoefficient = 1e6f;

class VelvetMaterial final : public Material {
  public:
    VelvetMaterial(const ParameterReader& reader, const AssetContext& assets)
        : kd_(read_reflectance(reader, assets, "Kd", Rgb(0.3f))),
          p1_(read_limited(reader, assets, "p1", -2, -kLargestCoefficient, kLargestCoefficient)),
          p2_(read_limited(reader, assets, "p2", 20, -kLargestCoefficient, kLargestCoefficient)),
          p3_(read_limited(reader, assets, "p3", 2, -kLargestCoefficient, kLargestCoefficient)),
          thickness_(read_limited(reader, assets, "thickness", 0.1f, 0, kLargestCoefficient)) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override;
    MaterialFacts facts() const override;

  private:
    PreparedColor kd_;
    PreparedFloat p1_, p2_, p3_, thickness_;
};

const Bsdf* VelvetMaterial::scatter(const ShadingPoint& point,
                                    std::pmr::memory_resource& memory) const {
    const Rgb kd = kd_.at(point.texture);
    const float thickness = thickness_.at(point.texture);
    if (is_black(kd) || thickness == 0) return nullptr;
    const FibrePhase phase{p1_.at(point.texture), p2_.at(point.texture), p3_.at(point.texture)};
    return place_bsdf<AsperityBsdf>(memory, kd, phase, thickness, point.ng, point.ns);
}

MaterialFacts VelvetMaterial::facts() const {
    MaterialFacts facts;
    if (kd_.is(Rgb(0.0f)) || thickness_.is(0)) return facts;
    facts.lobes = kDiffuse;
    facts.reads_image =
        p1_.reads_image() || p2_.reads_image() || p3_.reads_image() || thickness_.reads_image();
    kd_.add_to(facts);
    facts.max_bsdf_bytes = kBsdfBytes<AsperityBsdf>;
    return facts;
}

std::shared_ptr<const Material> create_velvet(const ParameterReader& reader,
                                              const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<VelvetMaterial>(reader, assets);
}

}  // namespace

MaterialFactory velvet_plugin() {
    using enum ParameterType;
    return {with_common_parameters(
                {{"Kd", ColorTexture, "0.3 0.3 0.3", "reflectance of the fibres, 0 to 1"},
                 {"p1", FloatTexture, "-2", "weight of the phase function's first Legendre term"},
                 {"p2", FloatTexture, "20", "weight of the second"},
                 {"p3", FloatTexture, "2", "weight of the third"},
                 {"thickness", FloatTexture, "0.1", "optical thickness of the layer", 0}}),
            &create_velvet};
}

}  // namespace lxs::shading
