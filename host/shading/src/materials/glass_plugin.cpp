// Material "glass": smooth dielectric in vacuum, solid or architectural.
#include "bsdfs/thin_glass_bsdf.h"
#include "common_parameters.h"
#include "glass_surface.h"
#include "lxs/sdk/index_curve.h"
#include "material_plugins.h"
#include "prepared_texture.h"
#include "surface_film.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

constexpr float kMinIndex = 0.05f, kMaxIndex = 20;

class GlassMaterial final : public Material {
  public:
    GlassMaterial(PreparedColor kr, PreparedColor kt, PreparedFloat index, PreparedFloat cauchy_b,
                  SurfaceFilm film, bool architectural, bool pane)
        : kr_(std::move(kr)),
          kt_(std::move(kt)),
          index_(std::move(index)),
          cauchy_b_(std::move(cauchy_b)),
          film_(std::move(film)),
          architectural_(architectural),
          pane_(pane) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        return scatter_glass(glass_at(point.texture), architectural_, point, memory);
    }
    MaterialFacts facts() const override {
        MaterialFacts facts = glass_facts(architectural_, !cauchy_b_.is(0));
        facts.own_index = !architectural_;
        facts.reads_image = index_.reads_image() || cauchy_b_.reads_image() || film_.reads_image();
        facts.reads_uv =
            kr_.varies() || kt_.varies() || index_.varies() || cauchy_b_.varies() || film_.varies();
        kr_.add_to(facts);
        kt_.add_to(facts);
        return facts;
    }
    Rgb straight_transmittance(const ShadingPoint& point, const Vec3& direction) const override {
        if (!architectural_) return Rgb(0.0f);
        const GlassPoint glass = glass_at(point.texture);
        return thin_glass_transmission(glass.kt, glass.eta, direction.dot(point.ns), pane_);
    }

  private:
    GlassPoint glass_at(const TexturePoint& point) const {
        const IndexCurve index{index_.at(point), cauchy_b_.at(point), 0};
        const auto at = [&](double nm) { return limited(index.at(nm), kMinIndex, kMaxIndex); };
        GlassPoint glass{kr_.at(point), kt_.at(point), at(kMiddleNm), film_.at(point)};
        glass.pane = pane_;
        if (const Wavelengths* w = point.wavelengths; w && index.varies()) {
            glass.etas = Rgb(at(w->nm[0]), at(w->nm[1]), at(w->nm[2]));
        }
        return glass;
    }

    PreparedColor kr_, kt_;
    PreparedFloat index_, cauchy_b_;
    SurfaceFilm film_;
    bool architectural_, pane_;
};

std::shared_ptr<const Material> create_glass(const ParameterReader& reader,
                                             const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<GlassMaterial>(
        read_reflectance(reader, assets, "Kr", Rgb(1.0f)),
        read_reflectance(reader, assets, "Kt", Rgb(1.0f)),
        read_limited(reader, assets, "index", 1.5f, kMinIndex, kMaxIndex),
        read_limited(reader, assets, "cauchyb", 0, 0, 1), SurfaceFilm(reader, assets),
        reader.boolean("architectural", false), reader.boolean("pane", false));
}

}  // namespace

MaterialFactory glass_plugin() {
    return {
        with_common_parameters(declarations(
            {{{"Kr", ParameterType::ColorTexture, "1 1 1", "colour of reflected light, 0 to 1"},
              {"Kt", ParameterType::ColorTexture, "1 1 1", "colour of refracted light, 0 to 1"},
              {"index", ParameterType::FloatTexture, "1.5", "index of refraction", 0},
              {"cauchyb", ParameterType::FloatTexture, "0",
               "Cauchy's B, square micrometres: the index is index + cauchyb / wavelength^2", 0},
              {"architectural", ParameterType::Bool, "false",
               "let light through undeviated, shadow rays too"},
              {"pane", ParameterType::Bool, "false",
               "architectural: a whole pane, both of whose faces reflect. Not LuxRender's."}},
             film_parameters()})),
        &create_glass};
}

}  // namespace lxs::shading
