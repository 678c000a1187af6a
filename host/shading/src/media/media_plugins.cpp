// Media "clear" (absorbing), "homogeneous" (absorbing and scattering) and "heterogeneous"
// (likewise, and varying in space). All may shine by themselves.
#include "media_plugins.h"

#include <fmt/format.h>

#include "lxs/spectrum/colour_matching.h"
#include "lxs/spectrum/wavelengths.h"
#include "materials/metal_presets.h"
#include "materials/prepared_texture.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

constexpr float kNoLimit = std::numeric_limits<float>::max();
/// Greatest coefficient: sums of two stay finite.
constexpr float kDensest = 1e30f;
/// Greatest mean cosine of scattering: beyond it single precision can't tell light from
/// unscattered.
constexpr float kMostAsymmetry = 0.999f;

/// The value of a texture that must be the same everywhere in a medium.
template <class T>
T value_everywhere(const std::shared_ptr<const Texture<T>>& texture, const ParameterReader& reader,
                   std::string_view name) {
    if (const std::optional<T> value = texture->constant()) return *value;
    reader.diagnostics().warning(reader.where(name),
                                 fmt::format("\"{}\" varies in space, which is not rendered yet; "
                                             "its value at the origin is used",
                                             name));
    return texture->evaluate(TexturePoint{});
}

IndexCurve read_index(const ParameterReader& reader, const AssetContext& assets) {
    const auto texture = read_fresnel_texture(reader, assets, "fresnel", 1);
    const Rgb eta = value_everywhere(texture, reader, "fresnel").eta;
    const IndexCurve index =
        eta == Rgb(eta.x) ? IndexCurve{eta.x}
                          : index_curve_through(
                                {kRgbWavelengths[0], kRgbWavelengths[1], kRgbWavelengths[2]}, eta);
    for (const double nm : {kFirstVisibleNm, kMiddleNm, kLastVisibleNm}) {
        if (!(index.at(nm) > 0))
            reader.fail("fresnel", "the index of refraction must be above 0 for visible light");
    }
    return index;
}

/// A colour that is the same everywhere, and its spectrum if it was given as one.
struct Coefficient {
    Rgb value{0.0f};
    CurvePointer spectrum;
};

/// Limited to [lowest, highest].
Coefficient read_coefficient(const ParameterReader& reader, const AssetContext& assets,
                             std::string_view name, float lowest, float highest) {
    const auto texture = read_color_texture(reader, assets, name, Rgb(0.0f));
    const Rgb value = value_everywhere(texture, reader, name);
    const Rgb inside = limited(value, lowest, highest);
    if (inside != value) {
        const std::string limit = highest < kNoLimit
                                      ? fmt::format("between {} and {}", lowest, highest)
                                      : fmt::format("{} and above", lowest);
        reader.diagnostics().warning(reader.where(name),
                                     fmt::format("\"{}\" is limited to {}", name, limit));
    }
    return {inside, texture->spectrum()};
}

ParameterDeclaration fresnel_parameter() {
    ParameterDeclaration fresnel{"fresnel", ParameterType::FresnelTexture, "1",
                                 "index of refraction, for \"glass2\""};
    fresnel.minimum = 1e-3;
    return fresnel;
}

/// Coefficients by textures in world space.
class TexturedField final : public MediumField {
  public:
    using Colour = std::shared_ptr<const ColorTexture>;
    TexturedField(Colour absorption, Colour scattering, Colour emission)
        : absorption_(std::move(absorption)),
          scattering_(std::move(scattering)),
          emission_(std::move(emission)) {}

    MediumCoefficients at(const Vec3& position, const Wavelengths* wavelengths) const override {
        TexturePoint point;
        point.p = position;
        point.wavelengths = wavelengths;
        return {of(*absorption_, point), of(*scattering_, point), Rgb(0.0f)};
    }
    Rgb emission(const Vec3& position, const Wavelengths* wavelengths) const override {
        TexturePoint point;
        point.p = position;
        point.use = ColourUse::Light;
        const Rgb sent = without_refused(emission_->evaluate(point));
        return wavelengths ? wavelengths->values_of(sent) : sent;
    }
    bool emits() const override { return is_above_zero(*emission_); }
    float cell_size() const override {
        return smaller_cell(absorption_->cell_size(), scattering_->cell_size());
    }
    bool scatters() const override { return is_above_zero(*scattering_); }

  private:
    /// Whether it is above 0 anywhere, as far as can be told.
    static bool is_above_zero(const ColorTexture& texture) {
        const std::optional<Rgb> everywhere = texture.constant();
        return !everywhere || max_component(*everywhere) > 0;
    }
    static Rgb of(const ColorTexture& texture, const TexturePoint& point) {
        Rgb value = texture.evaluate(point);
        if (point.wavelengths != nullptr) {
            const CurvePointer spectrum = texture.spectrum();
            value = spectrum ? spectrum->amounts_at(*point.wavelengths)
                             : point.wavelengths->values_of(value);
        }
        return without_refused(value);
    }
    static Rgb without_refused(const Rgb& value) {
        const auto valid = [](float x) { return x > 0 ? std::min(x, kDensest) : 0.0f; };
        return {valid(value.x), valid(value.y), valid(value.z)};
    }

    Colour absorption_, scattering_, emission_;
};

ParameterDeclaration emission_parameter() {
    return {"emission", ParameterType::ColorTexture, "0 0 0",
            "light of the medium's own: radiance per unit of distance"};
}

std::vector<ParameterDeclaration> scattering_parameters() {
    using enum ParameterType;
    return {fresnel_parameter(),
            {"sigma_a", ColorTexture, "0 0 0", "absorption per unit of distance"},
            {"sigma_s", ColorTexture, "0 0 0",
             "scattering per unit of distance; rendered with VolumeIntegrator \"multi\""},
            {"g", ColorTexture, "0 0 0",
             "mean cosine of the angle of scattering (Henyey and Greenstein's phase function), -1 "
             "to 1: backwards to forwards"},
            emission_parameter()};
}

}  // namespace

MediumFactory clear_plugin() {
    return {
        {fresnel_parameter(),
         {"absorption", ParameterType::ColorTexture, "0 0 0", "absorption per unit of distance"},
         emission_parameter()},
        [](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
            const auto absorption = read_coefficient(reader, assets, "absorption", 0, kNoLimit);
            const auto emission = read_coefficient(reader, assets, "emission", 0, kDensest);
            return SceneMedium(
                std::make_shared<Medium>(
                    MediumCoefficients{absorption.value, Rgb(0.0f), Rgb(0.0f), emission.value},
                    read_index(reader, assets)),
                {absorption.spectrum, nullptr});
        }};
}

MediumFactory homogeneous_plugin() {
    return {
        scattering_parameters(),
        [](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
            const auto absorption = read_coefficient(reader, assets, "sigma_a", 0, kNoLimit);
            const auto scattering = read_coefficient(reader, assets, "sigma_s", 0, kNoLimit);
            const auto g = read_coefficient(reader, assets, "g", -kMostAsymmetry, kMostAsymmetry);
            const auto emission = read_coefficient(reader, assets, "emission", 0, kDensest);
            return SceneMedium(
                std::make_shared<Medium>(
                    MediumCoefficients{absorption.value, scattering.value, g.value, emission.value},
                    read_index(reader, assets)),
                {absorption.spectrum, scattering.spectrum});
        }};
}

MediumFactory heterogeneous_plugin() {
    std::vector<ParameterDeclaration> parameters = scattering_parameters();
    ParameterDeclaration steps{"stepsize", ParameterType::Float, "1",
                               "length of LuxRender's steps"};
    steps.no_effect = true;
    parameters.push_back(steps);
    return {
        std::move(parameters),
        [](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
            const auto absorption = read_color_texture(reader, assets, "sigma_a", Rgb(0.0f));
            const auto scattering = read_color_texture(reader, assets, "sigma_s", Rgb(0.0f));
            const auto g = read_coefficient(reader, assets, "g", -kMostAsymmetry, kMostAsymmetry);
            const auto emission = read_color_texture(reader, assets, "emission", Rgb(0.0f));
            const auto field = std::make_shared<TexturedField>(absorption, scattering, emission);
            return SceneMedium(
                std::make_shared<Medium>(field, g.value, read_index(reader, assets)));
        }};
}

}  // namespace lxs::shading
