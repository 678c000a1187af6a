// Material "layered": up to four named materials on top of each other.
#include <algorithm>
#include <cmath>

#include "bsdfs/layered_bsdf.h"
#include "bsdfs/mix_bsdf.h"
#include "bsdfs/null_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "prepared_texture.h"

namespace lxs::shading {
namespace {

constexpr int kMaxLayers = LayeredBsdf::kMaxLayers;
constexpr std::string_view kMaterialNames[kMaxLayers] = {"namedmaterial1", "namedmaterial2",
                                                         "namedmaterial3", "namedmaterial4"};
constexpr std::string_view kOpacityNames[kMaxLayers] = {"opacity1", "opacity2", "opacity3",
                                                        "opacity4"};

struct Layer {
    std::shared_ptr<const Material> material;
    PreparedFloat opacity;  ///< share of light that meets the layer; the rest passes straight on

    bool has_gaps() const { return !opacity.is(1); }
    const Bsdf* scatter(const ShadingPoint& point, std::pmr::memory_resource& memory) const;
    Rgb straight_transmittance(const ShadingPoint& point, const Vec3& direction) const;
    MaterialFacts facts() const;
};

const Bsdf* Layer::scatter(const ShadingPoint& point, std::pmr::memory_resource& memory) const {
    const float share = opacity.at(point.texture);
    const Bsdf* gap = share < 1 ? place_bsdf<NullBsdf>(memory) : nullptr;
    if (share == 0) return gap;
    const Bsdf* bsdf = material->scatter(point, memory);
    return gap ? place_bsdf<MixBsdf>(memory, gap, bsdf, share, point.ns) : bsdf;
}

Rgb Layer::straight_transmittance(const ShadingPoint& point, const Vec3& direction) const {
    const float share = opacity.at(point.texture);
    const Rgb passed =
        material->facts().straight ? material->straight_transmittance(point, direction) : Rgb(0.0f);
    return passed * share + Rgb(1 - share);
}

MaterialFacts Layer::facts() const {
    MaterialFacts facts = material->facts();
    if (!has_gaps()) return facts;
    facts.lobes |= kSpecular;
    facts.transmits = facts.straight = true;
    facts.reads_image |= opacity.reads_image();
    facts.max_bsdf_bytes += kBsdfBytes<NullBsdf> + kBsdfBytes<MixBsdf>;
    return facts;
}

class LayeredMaterial final : public Material {
  public:
    LayeredMaterial(std::vector<Layer> layers, float thickness);

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override;
    MaterialFacts facts() const override { return facts_; }
    Rgb straight_transmittance(const ShadingPoint& point, const Vec3& direction) const override {
        Rgb share(1.0f);
        for (const Layer& layer : layers_)
            share *= layer.straight_transmittance(point, direction);
        const float gap = between_layers(thickness_, direction.dot(point.ns));
        return share * std::pow(gap, static_cast<float>(layers_.size() - 1));
    }

  private:
    std::vector<Layer> layers_;
    float thickness_;
    MaterialFacts facts_;
};

LayeredMaterial::LayeredMaterial(std::vector<Layer> layers, float thickness)
    : layers_(std::move(layers)), thickness_(thickness) {
    facts_.transmits = facts_.straight = true;
    for (const Layer& layer : layers_) {
        const MaterialFacts facts = layer.facts();
        facts_.lobes |= facts.lobes;
        facts_.transmits = facts_.transmits && facts.transmits;
        facts_.straight = facts_.straight && facts.straight;
        facts_.reads_image |= facts.reads_image;
        facts_.bends |= facts.bends;
        facts_.reads_dpdv |= facts.reads_dpdv;
        facts_.disperses |= facts.disperses;
        facts_.max_bsdf_bytes += facts.max_bsdf_bytes;
        facts_.add_spectra_of(facts);
    }
    facts_.max_bsdf_bytes += kBsdfBytes<LayeredBsdf>;
}

const Bsdf* LayeredMaterial::scatter(const ShadingPoint& point,
                                     std::pmr::memory_resource& memory) const {
    if (layers_.size() == 1) return layers_.front().scatter(point, memory);
    LayeredBsdf::Stack stack;
    stack.transmits = facts_.transmits;
    stack.thickness = thickness_;
    for (const Layer& layer : layers_)
        stack.layers[stack.count++] = layer.scatter(point, memory);
    return place_bsdf<LayeredBsdf>(memory, stack, point.texture.p, point.ng, point.ns);
}

std::shared_ptr<const Material> create_layered(const ParameterReader& reader,
                                               const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    std::vector<Layer> layers;
    for (int i = 0; i < kMaxLayers; ++i) {
        const std::string name = reader.string(kMaterialNames[i], "");
        if (name.empty()) continue;
        layers.push_back({assets.material(name, reader.where(kMaterialNames[i])),
                          read_limited(reader, assets, kOpacityNames[i], 1, 0, 1)});
    }
    if (layers.empty()) reader.fail("namedmaterial1", "layered: \"namedmaterial1\" is missing");
    const float thickness = std::max(0.0f, static_cast<float>(reader.number("thickness", 0)));
    return std::make_shared<LayeredMaterial>(std::move(layers), thickness);
}

}  // namespace

MaterialFactory layered_plugin() {
    std::vector<ParameterDeclaration> own;
    for (int i = 0; i < kMaxLayers; ++i) {
        own.push_back({kMaterialNames[i], ParameterType::String, "",
                       "name of a layer's material; the first one lies on the front"});
        own.push_back({kOpacityNames[i], ParameterType::FloatTexture, "1",
                       "share of light that meets the layer, 0 to 1; the rest passes straight"});
    }
    own.push_back({"thickness", ParameterType::Float, "0",
                   "of the gaps: exp(-thickness / cosine) of the light gets to the next layer", 0});
    return {with_common_parameters(std::move(own)), &create_layered};
}

}  // namespace lxs::shading
