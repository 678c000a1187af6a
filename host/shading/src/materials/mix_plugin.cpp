// Material "mix": two named materials, blended.
#include "bsdfs/mix_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "prepared_texture.h"

namespace lxs::shading {
namespace {

using MaterialPointer = std::shared_ptr<const Material>;

class MixMaterial final : public Material {
  public:
    MixMaterial(MaterialPointer first, MaterialPointer second, PreparedFloat amount)
        : first_(std::move(first)), second_(std::move(second)), amount_(std::move(amount)) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override;
    MaterialFacts facts() const override;
    Rgb straight_transmittance(const ShadingPoint& point, const Vec3& direction) const override;

  private:
    MaterialPointer first_, second_;
    PreparedFloat amount_;
};

const Bsdf* MixMaterial::scatter(const ShadingPoint& point,
                                 std::pmr::memory_resource& memory) const {
    const float amount = amount_.at(point.texture);
    if (amount == 0) return first_->scatter(point, memory);
    if (amount == 1) return second_->scatter(point, memory);
    const Bsdf* first = first_->scatter(point, memory);
    const Bsdf* second = second_->scatter(point, memory);
    if (!first && !second) return nullptr;
    return place_bsdf<MixBsdf>(memory, first, second, amount, point.ns);
}

MaterialFacts MixMaterial::facts() const {
    const MaterialFacts first = first_->facts(), second = second_->facts();
    MaterialFacts facts;
    facts.lobes = first.lobes | second.lobes;
    facts.transmits = first.transmits || second.transmits;
    facts.straight = first.straight || second.straight;
    facts.reads_image = first.reads_image || second.reads_image || amount_.reads_image();
    facts.bends = first.bends || second.bends;
    facts.reads_dpdv = first.reads_dpdv || second.reads_dpdv;
    facts.disperses = first.disperses || second.disperses;
    facts.add_spectra_of(first);
    facts.add_spectra_of(second);
    facts.max_bsdf_bytes = first.max_bsdf_bytes + second.max_bsdf_bytes + kBsdfBytes<MixBsdf>;
    return facts;
}

Rgb MixMaterial::straight_transmittance(const ShadingPoint& point, const Vec3& direction) const {
    const float amount = amount_.at(point.texture);
    return first_->straight_transmittance(point, direction) * (1 - amount) +
           second_->straight_transmittance(point, direction) * amount;
}

MaterialPointer create_mix(const ParameterReader& reader, const AssetContext& assets,
                           const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<MixMaterial>(read_named_material(reader, assets, "namedmaterial1"),
                                         read_named_material(reader, assets, "namedmaterial2"),
                                         read_limited(reader, assets, "amount", 0.5f, 0, 1));
}

}  // namespace

MaterialFactory mix_plugin() {
    return {with_common_parameters(
                {{"namedmaterial1", ParameterType::String, "", "name of the first material"},
                 {"namedmaterial2", ParameterType::String, "", "name of the second material"},
                 {"amount", ParameterType::FloatTexture, "0.5",
                  "share of the second material, 0 to 1"}}),
            &create_mix};
}

}  // namespace lxs::shading
