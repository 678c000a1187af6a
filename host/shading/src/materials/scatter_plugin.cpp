// Material "scatter": a surface that scatters like a particle.
#include "bsdfs/phase_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "prepared_texture.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

constexpr float kMostForward = 0.99f;

class ScatterMaterial final : public Material {
  public:
    ScatterMaterial(PreparedColor kd, PreparedColor g) : kd_(std::move(kd)), g_(std::move(g)) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        const Rgb kd = kd_.at(point.texture);
        if (is_black(kd)) return nullptr;
        return place_bsdf<PhaseBsdf>(memory, kd, g_.at(point.texture), point.ng, point.ns);
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        if (kd_.is(Rgb(0.0f))) return facts;
        facts.lobes = kDiffuse;
        facts.transmits = true;
        kd_.add_to(facts);
        g_.add_to(facts);
        facts.max_bsdf_bytes = kBsdfBytes<PhaseBsdf>;
        return facts;
    }

  private:
    PreparedColor kd_, g_;
};

std::shared_ptr<const Material> create_scatter(const ParameterReader& reader,
                                               const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<ScatterMaterial>(
        read_reflectance(reader, assets, "Kd", Rgb(0.9f)),
        PreparedColor(read_color_texture(reader, assets, "g", Rgb(0.0f)), -kMostForward,
                      kMostForward, ColourOf::Quantity, reader.texture_name("g").value_or("")));
}

}  // namespace

MaterialFactory scatter_plugin() {
    using enum ParameterType;
    return {with_common_parameters(
                {{"Kd", ColorTexture, "0.9 0.9 0.9", "share of light that is scattered, 0 to 1"},
                 {"g", ColorTexture, "0 0 0",
                  "mean cosine of the deflection, -0.99 to 0.99: 0 scatters evenly"}}),
            &create_scatter};
}

}  // namespace lxs::shading
