// Material "glass2": dielectric whose index and absorption are those of the media on its sides.
#include "bsdfs/thin_glass_bsdf.h"
#include "common_parameters.h"
#include "glass_surface.h"
#include "material_plugins.h"

namespace lxs::shading {
namespace {

GlassPoint glass_at(const ShadingPoint& point) {
    const float inside = point.interior ? point.interior->index() : 1.0f;
    const float outside = point.exterior ? point.exterior->index() : 1.0f;
    return {Rgb(1.0f), Rgb(1.0f), inside / outside, {}};
}

class Glass2Material final : public Material {
  public:
    explicit Glass2Material(bool architectural) : architectural_(architectural) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        return scatter_glass(glass_at(point), architectural_, point, memory);
    }
    MaterialFacts facts() const override { return glass_facts(architectural_); }
    Rgb straight_transmittance(const ShadingPoint& point, const Vec3& direction) const override {
        if (!architectural_) return Rgb(0.0f);
        const GlassPoint glass = glass_at(point);
        return thin_glass_transmission(glass.kt, glass.eta, direction.dot(point.ns));
    }

  private:
    bool architectural_;
};

std::shared_ptr<const Material> create(const ParameterReader& reader, const AssetContext& assets,
                                       const Matrix&) {
    warn_of_common_parameters(reader, assets);
    if (reader.boolean("dispersion", false)) {
        reader.diagnostics().warning(reader.where("dispersion"), "dispersion is not rendered yet");
    }
    return std::make_shared<Glass2Material>(reader.boolean("architectural", false));
}

}  // namespace

MaterialFactory glass2_plugin() {
    return {with_common_parameters({{"architectural", ParameterType::Bool, "false",
                                     "let light through undeviated, shadow rays too"},
                                    {"dispersion", ParameterType::Bool, "false",
                                     "index depends on the wavelength (not rendered yet)"}}),
            &create};
}

}  // namespace lxs::shading
