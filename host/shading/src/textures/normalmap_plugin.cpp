// Texture "normalmap": tangent-space normals in an image, to be used as a bump map.
#include <algorithm>

#include "texture_plugins.h"

namespace lxs::shading {
namespace {

/// The height is 0 everywhere, as in LuxRender; what it adds is the slope that gives the normal
/// 2 c - 1 for the colour c (red along u, green along v, blue along the surface's normal).
class NormalMapTexture final : public FloatTexture {
  public:
    explicit NormalMapTexture(std::shared_ptr<const ColorTexture> image)
        : image_(std::move(image)) {}
    float evaluate(const TexturePoint&) const override { return 0; }
    Vec2 mapped_slope(const TexturePoint& point) const override {
        constexpr float kLeastCosine = 1e-2f;  // to the surface's normal: a slope of 100
        const Rgb c = image_->evaluate(point);
        const float z = std::max(2 * c.z - 1, kLeastCosine);
        return {(1 - 2 * c.x) / z, (1 - 2 * c.y) / z};
    }
    bool reads_image() const override { return true; }

  private:
    std::shared_ptr<const ColorTexture> image_;
};

/// What the scene gives, without gamma unless it asks for one: colours are directions here.
ParameterSet image_parameters(const ParameterReader& reader) {
    ParameterSet set = reader.set();
    if (!reader.given("gamma")) {
        ParameterValue gamma;
        gamma.type = "float";
        gamma.name = "gamma";
        gamma.values = std::vector<double>{1.0};
        gamma.where = reader.where();
        set.values.push_back(std::move(gamma));
    }
    return set;
}

std::vector<ParameterDeclaration> declared(std::vector<ParameterDeclaration> image) {
    for (ParameterDeclaration& parameter : image) {
        if (parameter.name == "gamma") parameter.default_text = "1";
    }
    return image;
}

}  // namespace

FloatTextureFactory normalmap_plugin(const ColorTextureFactory& imagemap) {
    return {declared(imagemap.parameters),
            [imagemap](const ParameterReader& reader, const AssetContext& assets,
                       const Matrix& to_world) -> std::shared_ptr<const FloatTexture> {
                const ParameterSet set = image_parameters(reader);
                const ParameterReader image(set, imagemap.parameters, reader.diagnostics());
                return std::make_shared<NormalMapTexture>(imagemap.create(image, assets, to_world));
            }};
}

}  // namespace lxs::shading
