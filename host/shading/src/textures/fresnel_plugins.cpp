// Fresnel textures "fresnelcolor" and "fresnelname" (also "preset"): optical constants.
#include "bsdfs/fresnel.h"
#include "materials/metal_presets.h"
#include "materials/prepared_texture.h"
#include "texture_parameters.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

class FresnelColorTexture final : public FresnelTexture {
  public:
    explicit FresnelColorTexture(std::shared_ptr<const ColorTexture> reflectance)
        : reflectance_(std::move(reflectance)) {}
    FresnelValue evaluate(const TexturePoint& point) const override {
        return constants_of(reflectance_->evaluate(point));
    }
    std::optional<FresnelValue> constant() const override {
        const std::optional<Rgb> reflectance = reflectance_->constant();
        if (!reflectance) return std::nullopt;
        return constants_of(*reflectance);
    }
    bool reads_image() const override { return reflectance_->reads_image(); }

  private:
    static FresnelValue constants_of(const Rgb& reflectance) {
        return fresnel_from_reflectance(colour_of_reflectance(reflectance));
    }

    std::shared_ptr<const ColorTexture> reflectance_;
};

}  // namespace

FresnelTextureFactory fresnelcolor_plugin() {
    return {{{"Kr", ParameterType::ColorTexture, "0.5 0.5 0.5",
              "reflectance at normal incidence, 0 to 1"},
             {"n", ParameterType::Color, "",
              "index of refraction for R, G and B, in place of Kr. Not LuxRender's."},
             {"k", ParameterType::Color, "0 0 0", "extinction coefficient beside n"}},
            [](const ParameterReader& reader, const AssetContext& assets,
               const Matrix&) -> std::shared_ptr<const FresnelTexture> {
                if (reader.given("n")) {
                    const FresnelValue value{reader.color("n", Rgb(1.0f)),
                                             reader.color("k", Rgb(0.0f)), true};
                    return std::make_shared<ConstantTexture<FresnelValue>>(value);
                }
                auto reflectance = read_color_texture(reader, assets, "Kr", Rgb(0.5f));
                return std::make_shared<FresnelColorTexture>(std::move(reflectance));
            }};
}

FresnelTextureFactory fresnelname_plugin() {
    return {metal_preset_parameters(),
            [](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
                const FresnelValue value = read_metal_preset(reader, assets);
                return std::make_shared<ConstantTexture<FresnelValue>>(value);
            }};
}

}  // namespace lxs::shading
