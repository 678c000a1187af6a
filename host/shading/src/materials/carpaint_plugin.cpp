// Material "carpaint": diffuse base and three specular lobes, by parameters or by name.
#include <fmt/format.h>

#include "bsdfs/car_paint_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "car_paint_presets.h"
#include "common_parameters.h"
#include "material_plugins.h"
#include "prepared_texture.h"

namespace lxs::shading {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();
/// Sharper lobes would overflow and look like a mirror.
constexpr float kMinSlope = 1e-3f, kMaxSlope = 10;

/// Textures of one lobe.
struct LobeParameters {
    PreparedColor ks;
    PreparedFloat reflectance, slope;

    LobeParameters(const ParameterReader& reader, const AssetContext& assets, int number,
                   const CookTorranceLobe& fallback)
        : ks(read_reflectance(reader, assets, fmt::format("Ks{}", number), fallback.ks)),
          reflectance(
              read_limited(reader, assets, fmt::format("R{}", number), fallback.reflectance, 0, 1)),
          slope(read_limited(reader, assets, fmt::format("M{}", number), fallback.slope, kMinSlope,
                             kMaxSlope)) {}

    CookTorranceLobe at(const TexturePoint& point) const {
        return {ks.at(point), reflectance.at(point), slope.at(point)};
    }
    void add_to(MaterialFacts& facts) const {
        ks.add_to(facts);
        facts.reads_image |= reflectance.reads_image() || slope.reads_image();
    }
};

class CarPaintMaterial final : public Material {
  public:
    /// `preset`: null, or the paint whose base and lobes count instead of the parameters.
    CarPaintMaterial(const ParameterReader& reader, const AssetContext& assets,
                     const CarPaint* preset);

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override;
    MaterialFacts facts() const override;

  private:
    const CarPaint* preset_;
    PreparedColor kd_, ka_;
    PreparedFloat depth_;
    std::array<LobeParameters, 3> lobes_;
};

CarPaintMaterial::CarPaintMaterial(const ParameterReader& reader, const AssetContext& assets,
                                   const CarPaint* preset)
    : preset_(preset),
      kd_(read_reflectance(reader, assets, "Kd", car_paint_preset(kDefaultCarPaint).kd)),
      ka_(read_positive_color(reader, assets, "Ka", Rgb(0.0f))),
      depth_(read_limited(reader, assets, "d", 0, 0, kLargest)),
      lobes_{LobeParameters(reader, assets, 1, car_paint_preset(kDefaultCarPaint).lobes[0]),
             LobeParameters(reader, assets, 2, car_paint_preset(kDefaultCarPaint).lobes[1]),
             LobeParameters(reader, assets, 3, car_paint_preset(kDefaultCarPaint).lobes[2])} {}

const Bsdf* CarPaintMaterial::scatter(const ShadingPoint& point,
                                      std::pmr::memory_resource& memory) const {
    CarPaint paint;
    if (preset_) {
        paint = *preset_;
    } else {
        paint.kd = kd_.at(point.texture);
        for (int i = 0; i < 3; ++i)
            paint.lobes[i] = lobes_[i].at(point.texture);
    }
    paint.optical_depth = limited(ka_.at(point.texture) * depth_.at(point.texture), 0, kLargest);
    return place_bsdf<CarPaintBsdf>(memory, paint, Frame(point.ns, point.dpdu), point.ng);
}

MaterialFacts CarPaintMaterial::facts() const {
    MaterialFacts facts;
    facts.lobes = kDiffuse | kGlossy;
    if (preset_ ? is_black(preset_->kd) : kd_.is(Rgb(0.0f))) facts.lobes = kGlossy;
    facts.reads_image = depth_.reads_image();
    ka_.add_to(facts);
    if (!preset_) {
        kd_.add_to(facts);
        for (const LobeParameters& lobe : lobes_)
            lobe.add_to(facts);
    }
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

std::shared_ptr<const Material> create(const ParameterReader& reader, const AssetContext& assets,
                                       const Matrix&) {
    warn_of_common_parameters(reader);
    const CarPaint* preset = read_car_paint_preset(reader);
    if (preset) warn_of_overridden(reader);
    return std::make_shared<CarPaintMaterial>(reader, assets, preset);
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
              "absorption of the coating above the base per unit of depth"},
             {"d", FloatTexture, "0", "depth of that coating", 0},
             {"Ks1", ColorTexture, "", "weight of lobe 1, 0 to 1"},
             {"R1", FloatTexture, "", "reflectance of lobe 1's facets at normal incidence, 0 to 1",
              0},
             {"M1", FloatTexture, "", "root mean square slope of lobe 1's facets, 0.001 to 10", 0},
             {"Ks2", ColorTexture, "", "weight of lobe 2, 0 to 1"},
             {"R2", FloatTexture, "", "reflectance of lobe 2's facets at normal incidence, 0 to 1",
              0},
             {"M2", FloatTexture, "", "root mean square slope of lobe 2's facets, 0.001 to 10", 0},
             {"Ks3", ColorTexture, "", "weight of lobe 3, 0 to 1"},
             {"R3", FloatTexture, "", "reflectance of lobe 3's facets at normal incidence, 0 to 1",
              0},
             {"M3", FloatTexture, "", "root mean square slope of lobe 3's facets, 0.001 to 10",
              0}}),
        &create};
}

}  // namespace lxs::shading
