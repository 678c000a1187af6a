// Fresnel textures "fresnelcolor", "fresnelname" (also "preset") and "mix": optical constants.
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
        return fresnel_from_reflectance(reflectance_->evaluate(point));
    }
    std::optional<FresnelValue> constant() const override {
        const std::optional<Rgb> reflectance = reflectance_->constant();
        if (!reflectance) return std::nullopt;
        return fresnel_from_reflectance(*reflectance);
    }
    bool reads_image() const override { return reflectance_->reads_image(); }

  private:
    std::shared_ptr<const ColorTexture> reflectance_;
};

/// Blend of two textures of constants, n and k each.
class FresnelMixTexture final : public FresnelTexture {
  public:
    using Input = std::shared_ptr<const FresnelTexture>;

    FresnelMixTexture(Input first, Input second, std::shared_ptr<const FloatTexture> amount)
        : first_(std::move(first)), second_(std::move(second)), amount_(std::move(amount)) {}
    FresnelValue evaluate(const TexturePoint& point) const override {
        return blend(first_->evaluate(point), second_->evaluate(point), amount_->evaluate(point));
    }
    std::optional<FresnelValue> constant() const override {
        const auto first = first_->constant(), second = second_->constant();
        const std::optional<float> amount = amount_->constant();
        if (!first || !second || !amount) return std::nullopt;
        return blend(*first, *second, *amount);
    }
    bool reads_image() const override {
        return first_->reads_image() || second_->reads_image() || amount_->reads_image();
    }

  private:
    static FresnelValue blend(const FresnelValue& a, const FresnelValue& b, float share) {
        const float amount = limited(share, 0, 1);
        return {a.eta * (1 - amount) + b.eta * amount, a.k * (1 - amount) + b.k * amount,
                a.conductor || b.conductor};
    }

    Input first_, second_;
    std::shared_ptr<const FloatTexture> amount_;
};

}  // namespace

FresnelTextureFactory fresnelcolor_plugin() {
    return {{{"Kr", ParameterType::ColorTexture, "0.5 0.5 0.5",
              "reflectance at normal incidence, 0 to 1"}},
            [](const ParameterReader& reader, const AssetContext& assets,
               const Matrix&) -> std::shared_ptr<const FresnelTexture> {
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

FresnelTextureFactory mix_fresnel_plugin() {
    using enum ParameterType;
    return {{{"tex1", FresnelTexture, "1", "constants where amount is 0"},
             {"tex2", FresnelTexture, "1", "constants where amount is 1"},
             {"amount", FloatTexture, "0.5", "share of tex2, 0 to 1"}},
            [](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
                return std::make_shared<FresnelMixTexture>(
                    read_fresnel_texture(reader, assets, "tex1", 1),
                    read_fresnel_texture(reader, assets, "tex2", 1),
                    read_float_texture(reader, assets, "amount", 0.5f));
            }};
}

}  // namespace lxs::shading
