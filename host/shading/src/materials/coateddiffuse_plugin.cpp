// Material "coateddiffuse": pbrt-v4's, without a medium that scatters in the coat.
#include <algorithm>
#include <cstdint>

#include "bsdfs/coated_diffuse_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "rough_surface.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

constexpr float kMaxCoatIndex = 20;
constexpr std::int64_t kMostCrossings = 1'000'000;

class CoatedDiffuseMaterial final : public Material {
  public:
    CoatedDiffuseMaterial(const ParameterReader& reader, const AssetContext& assets)
        : kd_(read_reflectance(reader, assets, "Kd", Rgb(0.5f))),
          index_(
              std::clamp(static_cast<float>(reader.number("index", 1.5)), 1.001f, kMaxCoatIndex)),
          bounces_(static_cast<int>(
              std::clamp<std::int64_t>(reader.integer("maxdepth", 10), 2, kMostCrossings) / 2)),
          surface_(reader, assets, 0, "", RoughSurface::Facets::Smith),
          coat_(index_, std::max(0.0f, static_cast<float>(reader.number("thickness", 0.01))),
                surface_.least_alpha(), surface_.most_alpha()) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        return place_bsdf<CoatedDiffuseBsdf>(memory, kd_.at(point.texture), index_, bounces_, coat_,
                                             surface_.at(point));
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.lobes = kd_.is(Rgb(0.0f)) ? kGlossy : kDiffuse | kGlossy;
        facts.reads_image = surface_.reads_image();
        kd_.add_to(facts);
        facts.max_bsdf_bytes = kBsdfBytes<CoatedDiffuseBsdf>;
        return facts;
    }

  private:
    PreparedColor kd_;
    float index_;
    int bounces_;
    RoughSurface surface_;
    CoatTable coat_;
};

std::shared_ptr<const Material> create_coateddiffuse(const ParameterReader& reader,
                                                     const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<CoatedDiffuseMaterial>(reader, assets);
}

}  // namespace

MaterialFactory coateddiffuse_plugin() {
    using enum ParameterType;
    const std::vector<ParameterDeclaration> own{
        {"Kd", ColorTexture, "0.5 0.5 0.5", "diffuse reflectance of the base, 0 to 1"},
        {"index", Float, "1.5", "index of the coat, 1.001 to 20", 0},
        {"thickness", Float, "0.01",
         "of the coat: exp(-thickness / cosine) of the light crosses it", 0},
        {"maxdepth", Integer, "10",
         "crossings of the coat, down and up; two for each time that light comes to the base", 2}};
    return {with_common_parameters(declarations({own, roughness_parameters("0")})),
            &create_coateddiffuse};
}

}  // namespace lxs::shading
