// Material "shinymetal": a rough and a mirror-like metallic reflection.
#include "bsdfs/place_bsdf.h"
#include "bsdfs/shiny_metal_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "rough_surface.h"
#include "surface_film.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

class ShinyMetalMaterial final : public Material {
  public:
    ShinyMetalMaterial(PreparedColor ks, PreparedColor kr, SurfaceFilm film, RoughSurface surface)
        : ks_(std::move(ks)),
          kr_(std::move(kr)),
          film_(std::move(film)),
          surface_(std::move(surface)) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        return place_bsdf<ShinyMetalBsdf>(memory, fresnel_from_reflectance(ks_.at(point.texture)),
                                          fresnel_from_reflectance(kr_.at(point.texture)),
                                          film_.at(point.texture), surface_.at(point));
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.lobes = kGlossy | kSpecular;
        facts.reads_image = film_.reads_image() || surface_.reads_image();
        ks_.add_to(facts);
        kr_.add_to(facts);
        facts.max_bsdf_bytes = kBsdfBytes<ShinyMetalBsdf>;
        return facts;
    }

  private:
    PreparedColor ks_, kr_;
    SurfaceFilm film_;
    RoughSurface surface_;
};

std::shared_ptr<const Material> create_shinymetal(const ParameterReader& reader,
                                                  const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<ShinyMetalMaterial>(read_reflectance(reader, assets, "Ks", Rgb(1.0f)),
                                                read_reflectance(reader, assets, "Kr", Rgb(1.0f)),
                                                SurfaceFilm(reader, assets),
                                                RoughSurface(reader, assets));
}

}  // namespace

MaterialFactory shinymetal_plugin() {
    const std::vector<ParameterDeclaration> own{
        {"Kr", ParameterType::ColorTexture, "1 1 1",
         "reflectance of the mirror-like part at normal incidence, 0 to 1"},
        {"Ks", ParameterType::ColorTexture, "1 1 1",
         "reflectance of the rough part at normal incidence, 0 to 1"}};
    return {with_common_parameters(declarations(
                {declarations({own, roughness_parameters("0.1")}), film_parameters()})),
            &create_shinymetal};
}

}  // namespace lxs::shading
