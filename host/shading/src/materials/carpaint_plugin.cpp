// Material "carpaint": diffuse base and three specular lobes, by parameters or by name.
#include <fmt/format.h>

#include "bsdfs/car_paint_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "car_paint_presets.h"
#include "common_parameters.h"
#include "lxs/scene/constant_texture.h"
#include "material_plugins.h"
#include "prepared_texture.h"

namespace lxs::shading {
namespace {

PreparedFloat constant_number(float value) {
    return {std::make_shared<ConstantTexture<float>>(value), 0, 1};
}

/// Textures of one lobe.
struct LobeParameters {
    PreparedColor ks;
    PreparedFloat reflectance, roughness;

    explicit LobeParameters(const PaintLobe& lobe)
        : ks(constant_reflectance(lobe.ks)),
          reflectance(constant_number(lobe.reflectance)),
          roughness(constant_number(lobe.roughness)) {}

    LobeParameters(const ParameterReader& reader, const AssetContext& assets, int number,
                   const PaintLobe& fallback)
        : ks(read_reflectance(reader, assets, fmt::format("Ks{}", number), fallback.ks)),
          reflectance(
              read_limited(reader, assets, fmt::format("R{}", number), fallback.reflectance, 0, 1)),
          roughness(
              read_limited(reader, assets, fmt::format("M{}", number), fallback.roughness, 0, 1)) {}

    PaintLobe at(const TexturePoint& point) const {
        return {ks.at(point), reflectance.at(point), roughness.at(point)};
    }
    void add_to(MaterialFacts& facts) const {
        ks.add_to(facts);
        facts.reads_image |= reflectance.reads_image() || roughness.reads_image();
    }
};

/// Textures of base and lobes.
struct PaintParameters {
    PreparedColor kd;
    std::array<LobeParameters, 3> lobes;

    explicit PaintParameters(const CarPaint& paint)
        : kd(constant_reflectance(paint.kd)),
          lobes{LobeParameters(paint.lobes[0]), LobeParameters(paint.lobes[1]),
                LobeParameters(paint.lobes[2])} {}
    PaintParameters(const ParameterReader& reader, const AssetContext& assets,
                    const CarPaint& fallback)
        : kd(read_reflectance(reader, assets, "Kd", fallback.kd)),
          lobes{LobeParameters(reader, assets, 1, fallback.lobes[0]),
                LobeParameters(reader, assets, 2, fallback.lobes[1]),
                LobeParameters(reader, assets, 3, fallback.lobes[2])} {}
};

class CarPaintMaterial final : public Material {
  public:
    CarPaintMaterial(PaintParameters paint, const ParameterReader& reader,
                     const AssetContext& assets)
        : paint_(std::move(paint)),
          ka_(read_absorption(reader, assets, "Ka")),
          depth_(read_limited(reader, assets, "d", 0, 0, kUnlimited)) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override;
    MaterialFacts facts() const override;

  private:
    PaintParameters paint_;
    PreparedColor ka_;
    PreparedFloat depth_;
};

const Bsdf* CarPaintMaterial::scatter(const ShadingPoint& point,
                                      std::pmr::memory_resource& memory) const {
    CarPaint paint;
    paint.kd = paint_.kd.at(point.texture);
    for (std::size_t i = 0; i < 3; ++i)
        paint.lobes[i] = paint_.lobes[i].at(point.texture);
    paint.optical_depth = limited(ka_.at(point.texture) * depth_.at(point.texture), 0, kUnlimited);
    return place_bsdf<CarPaintBsdf>(memory, paint, Frame(point.ns, point.dpdu), point.ng);
}

MaterialFacts CarPaintMaterial::facts() const {
    MaterialFacts facts;
    facts.lobes = paint_.kd.is(Rgb(0.0f)) ? kGlossy : kDiffuse | kGlossy;
    facts.reads_image = depth_.reads_image();
    ka_.add_to(facts);
    paint_.kd.add_to(facts);
    for (const LobeParameters& lobe : paint_.lobes)
        lobe.add_to(facts);
    facts.max_bsdf_bytes = kBsdfBytes<CarPaintBsdf>;
    return facts;
}

/// A named paint has its own base and lobes.
void warn_of_overridden(const ParameterReader& reader) {
    for (const std::string_view name :
         {"Kd", "Ks1", "Ks2", "Ks3", "R1", "R2", "R3", "M1", "M2", "M3"}) {
        if (reader.given(name))
            reader.diagnostics().warning(
                reader.where(name),
                fmt::format("\"{}\" has no effect beside the paint's \"name\"", name));
    }
}

std::shared_ptr<const Material> create_carpaint(const ParameterReader& reader,
                                                const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    const CarPaint* preset = read_car_paint_preset(reader);
    if (preset) warn_of_overridden(reader);
    PaintParameters paint =
        preset ? PaintParameters(*preset)
               : PaintParameters(reader, assets, car_paint_preset(kDefaultCarPaint));
    return std::make_shared<CarPaintMaterial>(std::move(paint), reader, assets);
}

}  // namespace

MaterialFactory carpaint_plugin() {
    using enum ParameterType;
    return {
        with_common_parameters(
            {{"name", String, "",
              "ford f8, polaris silber, opel titan, bmw339, 2k acrylack, white, blue or blue "
              "matte; "
              "without one the parameters below count"},
             {"Kd", ColorTexture, "",
              "diffuse reflectance of the base, 0 to 1 (default: ford f8's)"},
             {"Ka", ColorTexture, "0 0 0",
              "absorption of the coating above the base per unit of depth, 0 to 1"},
             {"d", FloatTexture, "0", "depth of that coating", 0},
             {"Ks1", ColorTexture, "", "weight of lobe 1, 0 to 1"},
             {"R1", FloatTexture, "", "reflectance of lobe 1's facets at normal incidence, 0 to 1",
              0},
             {"M1", FloatTexture, "", "roughness of lobe 1, 0.006 to 1; at 0 there is none", 0},
             {"Ks2", ColorTexture, "", "weight of lobe 2, 0 to 1"},
             {"R2", FloatTexture, "", "reflectance of lobe 2's facets at normal incidence, 0 to 1",
              0},
             {"M2", FloatTexture, "", "roughness of lobe 2, 0.006 to 1; at 0 there is none", 0},
             {"Ks3", ColorTexture, "", "weight of lobe 3, 0 to 1"},
             {"R3", FloatTexture, "", "reflectance of lobe 3's facets at normal incidence, 0 to 1",
              0},
             {"M3", FloatTexture, "", "roughness of lobe 3, 0.006 to 1; at 0 there is none", 0}}),
        &create_carpaint};
}

}  // namespace lxs::shading
