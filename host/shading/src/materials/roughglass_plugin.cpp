// Material "roughglass": rough dielectric in vacuum.
#include <algorithm>

#include "bsdfs/dispersive_rough_glass_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "lxs/sdk/index_curve.h"
#include "material_plugins.h"
#include "rough_surface.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

constexpr float kMinRoughIndex = 0.05f, kMaxRoughIndex = 20;
/// LuxRender's default.
constexpr float kDefaultRoughness = 0.001f;

/// An index of 1 bends nothing, so that no facet can be told from the directions: the nearest index
/// with which one can looks the same.
float bending_index(float index) {
    constexpr float kLeastBend = 1e-3f;
    if (std::abs(index - 1) >= kLeastBend) return index;
    return index < 1 ? 1 - kLeastBend : 1 + kLeastBend;
}

class RoughGlassMaterial final : public Material {
  public:
    RoughGlassMaterial(const ParameterReader& reader, const AssetContext& assets)
        : kr_(read_reflectance(reader, assets, "Kr", Rgb(1.0f))),
          kt_(read_reflectance(reader, assets, "Kt", Rgb(1.0f))),
          index_(read_limited(reader, assets, "index", 1.5f, kMinRoughIndex, kMaxRoughIndex)),
          cauchy_b_(read_limited(reader, assets, "cauchyb", 0, 0, 1)),
          surface_(reader, assets, kDefaultRoughness, "", read_facets(reader)),
          disperses_(reader.boolean("dispersion", false) && !cauchy_b_.is(0)) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override;
    MaterialFacts facts() const override;

  private:
    PreparedColor kr_, kt_;
    PreparedFloat index_, cauchy_b_;
    RoughSurface surface_;
    bool disperses_;
};

const Bsdf* RoughGlassMaterial::scatter(const ShadingPoint& point,
                                        std::pmr::memory_resource& memory) const {
    const Rgb kr = kr_.at(point.texture), kt = kt_.at(point.texture);
    if (is_black(kr) && is_black(kt)) return nullptr;
    const IndexCurve index{index_.at(point.texture), cauchy_b_.at(point.texture), 0};
    const auto at = [&](double nm) {
        return bending_index(limited(index.at(nm), kMinRoughIndex, kMaxRoughIndex));
    };
    const Wavelengths* const w = point.texture.wavelengths;
    if (disperses_ && w && index.varies()) {
        const Rgb etas(at(w->nm[0]), at(w->nm[1]), at(w->nm[2]));
        return place_bsdf<DispersiveRoughGlassBsdf>(memory, kr, kt, etas, point.component,
                                                    surface_.at(point));
    }
    return place_bsdf<RoughGlassBsdf>(memory, kr, kt, at(kMiddleNm), surface_.at(point));
}

MaterialFacts RoughGlassMaterial::facts() const {
    MaterialFacts facts;
    facts.lobes = kGlossy;
    facts.transmits = facts.own_index = true;
    facts.reads_image = index_.reads_image() || cauchy_b_.reads_image() || surface_.reads_image();
    kr_.add_to(facts);
    kt_.add_to(facts);
    facts.disperses = disperses_;
    facts.max_bsdf_bytes =
        std::max(kBsdfBytes<RoughGlassBsdf>, kBsdfBytes<DispersiveRoughGlassBsdf>);
    return facts;
}

std::shared_ptr<const Material> create_roughglass(const ParameterReader& reader,
                                                  const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<RoughGlassMaterial>(reader, assets);
}

}  // namespace

MaterialFactory roughglass_plugin() {
    using enum ParameterType;
    const std::vector<ParameterDeclaration> own{
        {"Kr", ColorTexture, "1 1 1", "colour of reflected light, 0 to 1"},
        {"Kt", ColorTexture, "1 1 1", "colour of refracted light, 0 to 1"},
        {"index", FloatTexture, "1.5", "index of refraction", 0},
        {"cauchyb", FloatTexture, "0",
         "Cauchy's B, square micrometres: the index is index + cauchyb / wavelength^2", 0},
        {"dispersion", Bool, "false",
         "bend each wavelength by its own index; else all by that of 550 nm"}};
    return {with_common_parameters(declarations({own, facet_parameters("0.001")})),
            &create_roughglass};
}

}  // namespace lxs::shading
