// Texture "colordepth": the absorption that leaves a colour of light after a depth.
#include <algorithm>
#include <cmath>

#include "texture_parameters.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

constexpr float kDarkest = 1e-9f;  // of transmitted light: keeps the coefficient finite

/// Beer's law, solved for the coefficient.
Rgb absorption(const Rgb& transmitted, float depth) {
    const auto channel = [depth](float t) {
        return -std::log(std::clamp(t, kDarkest, 1.0f)) / depth;
    };
    return Rgb(channel(transmitted.x), channel(transmitted.y), channel(transmitted.z));
}

/// Absorption for a transmitted colour that is a texture.
class ColorDepth final : public ColorTexture {
  public:
    ColorDepth(std::shared_ptr<const ColorTexture> transmitted, float depth)
        : transmitted_(std::move(transmitted)), depth_(depth) {}
    Rgb evaluate(const TexturePoint& point) const override {
        return absorption(transmitted_->evaluate(point), depth_);
    }
    std::optional<Rgb> constant() const override {
        const std::optional<Rgb> transmitted = transmitted_->constant();
        return transmitted ? std::optional<Rgb>(absorption(*transmitted, depth_)) : std::nullopt;
    }
    bool reads_image() const override { return transmitted_->reads_image(); }

  private:
    std::shared_ptr<const ColorTexture> transmitted_;
    float depth_;
};

}  // namespace

ColorTextureFactory colordepth_plugin() {
    constexpr double kThinnest = 1e-6;
    return {{{"depth", ParameterType::Float, "1", "depth in scene units at which Kt is left",
              kThinnest},
             {"Kt", ParameterType::ColorTexture, "0 0 0", "share of light left at that depth"}},
            [](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
                return std::make_shared<ColorDepth>(
                    read_color_texture(reader, assets, "Kt", Rgb(0.0f)),
                    static_cast<float>(reader.number("depth", 1)));
            }};
}

}  // namespace lxs::shading
