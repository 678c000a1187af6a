// Material "mirror": ideal reflection, or that of a smooth metal.
#include <optional>

#include "bsdfs/mirror_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "prepared_texture.h"
#include "surface_film.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

class MirrorMaterial final : public Material {
  public:
    MirrorMaterial(PreparedColor kr, std::optional<PreparedFresnel> metal, SurfaceFilm film)
        : kr_(std::move(kr)), metal_(std::move(metal)), film_(std::move(film)) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        const Rgb kr = kr_.at(point.texture);
        if (is_black(kr)) return nullptr;
        std::optional<FresnelValue> metal;
        if (metal_) metal = metal_->at(point.texture);
        return place_bsdf<MirrorBsdf>(memory, kr, metal, film_.at(point.texture), point.ng,
                                      point.ns);
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.lobes = kSpecular;
        facts.reads_image = film_.reads_image() || (metal_ && metal_->reads_image());
        facts.reads_uv = kr_.varies() || film_.varies();
        kr_.add_to(facts);
        facts.max_bsdf_bytes = kBsdfBytes<MirrorBsdf>;
        return facts;
    }

  private:
    PreparedColor kr_;
    std::optional<PreparedFresnel> metal_;
    SurfaceFilm film_;
};

std::shared_ptr<const Material> create_mirror(const ParameterReader& reader,
                                              const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    std::optional<PreparedFresnel> metal;
    if (reader.given("fresnel")) metal.emplace(read_fresnel_texture(reader, assets, "fresnel", 1));
    return std::make_shared<MirrorMaterial>(read_reflectance(reader, assets, "Kr", Rgb(1.0f)),
                                            std::move(metal), SurfaceFilm(reader, assets));
}

}  // namespace

MaterialFactory mirror_plugin() {
    return {with_common_parameters(
                declarations({{{"Kr", ParameterType::ColorTexture, "1 1 1", "reflectance, 0 to 1"},
                               {"fresnel", ParameterType::FresnelTexture, "",
                                "optical constants of a smooth metal, whose reflectance Kr is a "
                                "factor on; without them Kr is all. Not LuxRender's."}},
                              film_parameters()})),
            &create_mirror};
}

}  // namespace lxs::shading
