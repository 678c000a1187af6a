// Material "null": light passes as if the surface weren't there.
#include "bsdfs/null_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"

namespace lxs::shading {
namespace {

class NullMaterial final : public Material {
  public:
    const Bsdf* scatter(const ShadingPoint&, std::pmr::memory_resource& memory) const override {
        return place_bsdf<NullBsdf>(memory);
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.lobes = kSpecular;
        facts.transmits = facts.straight = true;
        facts.max_bsdf_bytes = kBsdfBytes<NullBsdf>;
        return facts;
    }
    Rgb straight_transmittance(const ShadingPoint&, const Vec3&) const override {
        return Rgb(1.0f);
    }
};

}  // namespace

MaterialFactory null_plugin() {
    return {with_common_parameters({}),
            [](const ParameterReader& reader, const AssetContext&, const Matrix&) {
                warn_of_common_parameters(reader);
                return std::make_shared<NullMaterial>();
            }};
}

}  // namespace lxs::shading
