// Textures "fresnelcolor", "fresnelname" and "cauchy": optical constants.
#include "bsdfs/fresnel.h"
#include "materials/metal_presets.h"
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

std::shared_ptr<const FresnelTexture> create_cauchy(const ParameterReader& reader,
                                                    const AssetContext&, const Matrix&) {
    const auto b = static_cast<float>(reader.number("cauchyb", 0.00354));
    const auto index = static_cast<float>(reader.number("index", -1));
    constexpr float kSodiumD = 0.5893f;  // micrometres; indices of glass are given there
    const float a = index > 0 ? index - b / (kSodiumD * kSodiumD)
                              : static_cast<float>(reader.number("cauchya", 1.458));
    FresnelValue value;
    for (int i = 0; i < 3; ++i) {
        const float wavelength = 1e-3f * kRgbWavelengths[i];
        value.eta[i] = a + b / (wavelength * wavelength);
    }
    if (!(value.eta.x > 0 && value.eta.y > 0 && value.eta.z > 0))
        reader.fail("cauchyb", "cauchy: the index of refraction is not above 0 for visible light");
    return std::make_shared<ConstantTexture<FresnelValue>>(value);
}

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
            [](const ParameterReader& reader, const AssetContext&, const Matrix&) {
                const FresnelValue value = read_metal_preset(reader);
                return std::make_shared<ConstantTexture<FresnelValue>>(value);
            }};
}

FresnelTextureFactory cauchy_plugin() {
    return {
        {{"cauchya", ParameterType::Float, "1.458", "Cauchy's A: index for long waves"},
         {"cauchyb", ParameterType::Float, "0.00354", "Cauchy's B, square micrometres"},
         {"index", ParameterType::Float, "-1", "index at 589 nm; when above 0, A follows from it"}},
        &create_cauchy};
}

}  // namespace lxs::shading
