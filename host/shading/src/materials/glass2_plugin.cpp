// Material "glass2": dielectric whose index and absorption are those of the media on its sides.
#include "bsdfs/thin_glass_bsdf.h"
#include "common_parameters.h"
#include "glass_surface.h"
#include "material_plugins.h"

namespace lxs::shading {
namespace {

IndexCurve index_of(const Medium* medium) {
    return medium ? medium->index_curve() : IndexCurve{};
}

GlassPoint glass_at(const ShadingPoint& point, bool disperses) {
    const IndexCurve inside = index_of(point.interior), outside = index_of(point.exterior);
    const auto at = [&](double nm) { return inside.at(nm) / outside.at(nm); };
    GlassPoint glass{Rgb(1.0f), Rgb(1.0f), at(kMiddleNm)};
    const Wavelengths* const w = point.texture.wavelengths;
    if (disperses && w && (inside.varies() || outside.varies())) {
        glass.etas = Rgb(at(w->nm[0]), at(w->nm[1]), at(w->nm[2]));
    }
    return glass;
}

class Glass2Material final : public Material {
  public:
    Glass2Material(bool architectural, bool disperses)
        : architectural_(architectural), disperses_(disperses) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        return scatter_glass(glass_at(point, disperses_), architectural_, point, memory);
    }
    MaterialFacts facts() const override {
        MaterialFacts facts = glass_facts(architectural_, disperses_);
        facts.index_of_media = true;
        return facts;
    }
    Rgb straight_transmittance(const ShadingPoint& point, const Vec3& direction) const override {
        if (!architectural_) return Rgb(0.0f);
        const GlassPoint glass = glass_at(point, disperses_);
        return thin_glass_transmission(glass.kt, glass.eta, direction.dot(point.ns));
    }

  private:
    bool architectural_, disperses_;
};

std::shared_ptr<const Material> create_glass2(const ParameterReader& reader,
                                              const AssetContext& /*assets*/, const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<Glass2Material>(reader.boolean("architectural", false),
                                            reader.boolean("dispersion", false));
}

}  // namespace

MaterialFactory glass2_plugin() {
    return {with_common_parameters(
                {{"architectural", ParameterType::Bool, "false",
                  "let light through undeviated, shadow rays too"},
                 {"dispersion", ParameterType::Bool, "false",
                  "bend each wavelength by its own index, where those of the volumes differ"}}),
            &create_glass2};
}

}  // namespace lxs::shading
