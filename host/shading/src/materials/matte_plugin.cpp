// Material "matte": diffuse, smooth (Lambert) or rough (Oren & Nayar).
#include "bsdfs/lambert_bsdf.h"
#include "bsdfs/oren_nayar_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "prepared_texture.h"

namespace lxs::shading {
namespace {

class MatteMaterial final : public Material {
  public:
    MatteMaterial(PreparedColor kd, PreparedFloat sigma)
        : kd_(std::move(kd)), sigma_(std::move(sigma)) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        const Rgb kd = kd_.at(point.texture);
        if (is_black(kd)) return nullptr;
        const float sigma = sigma_.at(point.texture);
        if (sigma == 0) return place_bsdf<LambertBsdf>(memory, kd, point.ng, point.ns);
        return place_bsdf<OrenNayarBsdf>(memory, kd, sigma * kRadiansPerDegree, point.ng, point.ns);
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        if (kd_.is(Rgb(0.0f))) return facts;
        facts.lobes = kDiffuse;
        facts.reads_image = sigma_.reads_image();
        facts.reads_uv = kd_.varies() || sigma_.varies();
        kd_.add_to(facts);
        facts.max_bsdf_bytes = sigma_.is(0)
                                   ? kBsdfBytes<LambertBsdf>
                                   : std::max(kBsdfBytes<LambertBsdf>, kBsdfBytes<OrenNayarBsdf>);
        return facts;
    }

  private:
    PreparedColor kd_;
    PreparedFloat sigma_;
};

std::shared_ptr<const Material> create_matte(const ParameterReader& reader,
                                             const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<MatteMaterial>(read_reflectance(reader, assets, "Kd", Rgb(0.9f)),
                                           read_limited(reader, assets, "sigma", 0, 0, 90));
}

}  // namespace

MaterialFactory matte_plugin() {
    return {with_common_parameters(
                {{"Kd", ParameterType::ColorTexture, "0.9 0.9 0.9", "diffuse reflectance, 0 to 1"},
                 {"sigma", ParameterType::FloatTexture, "0",
                  "roughness: deviation of the facets' slope in degrees, 0 to 90", 0}}),
            &create_matte};
}

}  // namespace lxs::shading
