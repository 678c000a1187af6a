// Material "cloth": woven of two kinds of yarn.
#include <algorithm>
#include <cmath>

#include "bsdfs/channels.h"
#include "bsdfs/lambert_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "bsdfs/woven_bsdf.h"
#include "cloth_presets.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "prepared_texture.h"

namespace lxs::shading {
namespace {

constexpr double kDefaultRepeat = 100;

/// Warp or weft.
struct YarnParameters {
    BentYarn yarn;
    PreparedColor kd, ks;

    YarnParameters(const Yarn& preset, const ParameterReader& reader, const AssetContext& assets,
                   const std::string& name)
        : yarn(preset),
          kd(read_reflectance(reader, assets, name + "_Kd", Rgb(0.0f))),
          ks(read_reflectance(reader, assets, name + "_Ks", Rgb(0.0f))) {}

    void add_to(MaterialFacts& facts) const {
        kd.add_to(facts);
        ks.add_to(facts);
    }
};

class ClothMaterial final : public Material {
  public:
    ClothMaterial(const ClothPreset& preset, const ParameterReader& reader,
                  const AssetContext& assets)
        : weave_(preset.weave),
          warp_(preset.warp, reader, assets, "warp"),
          weft_(preset.weft, reader, assets, "weft"),
          repeat_(static_cast<float>(reader.number("repeat_u", kDefaultRepeat)),
                  static_cast<float>(reader.number("repeat_v", kDefaultRepeat))) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override;
    MaterialFacts facts() const override;

  private:
    Weave weave_;
    YarnParameters warp_, weft_;
    Vec2 repeat_;
};

const Bsdf* ClothMaterial::scatter(const ShadingPoint& point,
                                   std::pmr::memory_resource& memory) const {
    const WovenPlace place =
        locate_in_weave(weave_, point.texture.uv.x * repeat_.x, point.texture.uv.y * repeat_.y);
    const YarnParameters& top = place.warp ? warp_ : weft_;
    Rgb kd = top.kd.at(point.texture), ks = top.ks.at(point.texture);
    share_light(kd, ks);
    if (is_black(ks)) {
        if (is_black(kd)) return nullptr;
        return place_bsdf<LambertBsdf>(memory, kd, point.ng, point.ns);
    }
    const Frame frame(point.ns, point.dpdu);
    const float u = std::copysign(1.0f, repeat_.x);
    const float v = std::copysign(1.0f, repeat_.y) * (frame.t.dot(point.dpdv) < 0 ? -1.0f : 1.0f);
    return place_bsdf<WovenBsdf>(memory, kd, ks, top.yarn.at(place, u, v), frame, point.ng);
}

MaterialFacts ClothMaterial::facts() const {
    MaterialFacts facts;
    const Rgb black(0.0f);
    if (!warp_.kd.is(black) || !weft_.kd.is(black)) facts.lobes |= kDiffuse;
    if (!warp_.ks.is(black) || !weft_.ks.is(black)) facts.lobes |= kGlossy;
    warp_.add_to(facts);
    weft_.add_to(facts);
    facts.reads_dpdv = (facts.lobes & kGlossy) != 0;
    if (facts.lobes)
        facts.max_bsdf_bytes = std::max(kBsdfBytes<LambertBsdf>, kBsdfBytes<WovenBsdf>);
    return facts;
}

std::shared_ptr<const Material> create_cloth(const ParameterReader& reader,
                                             const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<ClothMaterial>(read_cloth_preset(reader), reader, assets);
}

}  // namespace

MaterialFactory cloth_plugin() {
    using enum ParameterType;
    return {
        with_common_parameters(
            {{"presetname", String, "denim",
              "denim, silk_charmeuse, cotton_twill, wool_gabardine, polyester_lining_cloth or "
              "silk_shantung: weave and fibres (see docs/reference/shading.md)"},
             {"warp_Kd", ColorTexture, "0 0 0",
              "diffuse reflectance of the warp, which runs along v, 0 to 1"},
             {"warp_Ks", ColorTexture, "0 0 0",
              "specular reflectance of its fibres, 0 to 1; where the sum of both exceeds 1, both "
              "are scaled down"},
             {"weft_Kd", ColorTexture, "0 0 0",
              "diffuse reflectance of the weft, which runs along u, 0 to 1"},
             {"weft_Ks", ColorTexture, "0 0 0", "specular reflectance of its fibres, 0 to 1"},
             {"repeat_u", Float, "100", "repeats of the weave per unit of u"},
             {"repeat_v", Float, "100", "repeats of the weave per unit of v"}}),
        &create_cloth};
}

}  // namespace lxs::shading
