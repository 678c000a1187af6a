// A texture as a material uses it: limited to what makes sense, its value kept if it is constant.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

#include "lxs/scene/refused_values.h"
#include "lxs/scene/registry.h"
#include "lxs/spectrum/reflectance_colour.h"

namespace lxs::shading {

/// Highest value of a parameter that may be as large as it likes.
inline constexpr float kUnlimited = std::numeric_limits<float>::max();

/// `value` limited to [lowest, highest]; NaN becomes `lowest`.
inline float limited(float value, float lowest, float highest) {
    return value >= lowest ? std::min(value, highest) : lowest;
}
inline Rgb limited(const Rgb& value, float lowest, float highest) {
    return {limited(value.x, lowest, highest), limited(value.y, lowest, highest),
            limited(value.z, lowest, highest)};
}

/// What a colour is the colour of.
enum class ColourOf : std::uint8_t {
    Surface,  ///< a reflectance or transmittance: turned to what LuxRender's lamps show of it
    Quantity  ///< absorption and the like: as it is written
};

template <class T>
class PreparedTexture {
  public:
    /// `name`: of the texture, for the count of what is refused.
    PreparedTexture(std::shared_ptr<const Texture<T>> texture, float lowest, float highest,
                    ColourOf of = ColourOf::Quantity, std::string name = {})
        : lowest_(lowest), highest_(highest), of_(of), name_(std::move(name)) {
        if (const std::optional<T> value = texture->constant()) {
            spectrum_ = texture->spectrum();
            constant_ = spectrum_ ? limited(*value, lowest, highest) : seen(*value);
        } else {
            texture_ = std::move(texture);
        }
    }
    /// A colour is given at the point's wavelengths, if it has any.
    T at(const TexturePoint& point) const {
        if constexpr (std::is_same_v<T, Rgb>) {
            if (point.wavelengths) return at_wavelengths(point);
        }
        return texture_ ? evaluated(point) : constant_;
    }
    /// True if the value is `value` everywhere.
    bool is(const T& value) const { return !texture_ && constant_ == value; }
    bool reads_image() const { return texture_ && texture_->reads_image(); }
    /// True if the value depends on the place, so that it may read texture coordinates.
    bool varies() const { return texture_ != nullptr; }
    /// Adds what is true of a material by this texture.
    void add_to(MaterialFacts& facts) const {
        facts.reads_image |= reads_image();
        if (spectrum_) facts.spectra.push_back(spectrum_);
    }

  private:
    T at_wavelengths(const TexturePoint& point) const {
        const Wavelengths& wavelengths = *point.wavelengths;
        if (spectrum_) return limited(spectrum_->at(wavelengths), lowest_, highest_);
        return wavelengths.values_of(texture_ ? evaluated(point) : constant_);
    }
    /// Within the limits, and as the colour that it is.
    T seen(const T& value) const {
        const T kept = limited(value, lowest_, highest_);
        if constexpr (std::is_same_v<T, Rgb>) {
            if (of_ == ColourOf::Surface)
                return limited(colour_of_reflectance(kept), lowest_, highest_);
        }
        return kept;
    }
    /// What is cut off at the limits is meant so; what is no number, or a negative colour, is not.
    T evaluated(const TexturePoint& point) const {
        const T value = texture_->evaluate(point);
        bool usable = is_finite(value);
        if constexpr (std::is_same_v<T, Rgb>) usable &= lowest_ < 0 || !is_negative(value);
        if (!usable && point.refused) point.refused->count(name_);
        return seen(is_finite(value) ? value : T(0.0f));
    }

    T constant_{};
    CurvePointer spectrum_;  ///< of a constant colour that was given as one; else null
    float lowest_, highest_;
    ColourOf of_;
    std::string name_;
    std::shared_ptr<const Texture<T>> texture_;  ///< null for a constant
};

using PreparedFloat = PreparedTexture<float>;
using PreparedColor = PreparedTexture<Rgb>;

/// A reflectance or transmittance in LuxRender's colour of it: limited to [0, 1] per channel, with
/// a warning at the parameter, which names the texture, if a constant lies outside.
PreparedColor read_reflectance(const ParameterReader& reader, const AssetContext& assets,
                               std::string_view name, const Rgb& fallback);
/// The same that is `value` everywhere.
PreparedColor constant_reflectance(const Rgb& value);
/// Absorption of a coating per unit of depth, black by default: LuxRender limits it to [0, 1] too,
/// and leaves the depth free.
PreparedColor read_absorption(const ParameterReader& reader, const AssetContext& assets,
                              std::string_view name);
/// A number limited to [lowest, highest], with a warning at the parameter if a constant that the
/// scene gives lies outside.
PreparedFloat read_limited(const ParameterReader& reader, const AssetContext& assets,
                           std::string_view name, float fallback, float lowest, float highest);

/// Optical constants, kept if they are constant, and limited to what matter has: sums of textures
/// may name an index below 0, or none.
class PreparedFresnel {
  public:
    explicit PreparedFresnel(std::shared_ptr<const FresnelTexture> texture);
    explicit PreparedFresnel(const FresnelValue& value) : constant_(possible(value)) {}
    /// At the point's wavelengths, if it has any.
    FresnelValue at(const TexturePoint& point) const {
        const FresnelValue value = texture_ ? possible(texture_->evaluate(point)) : constant_;
        return point.wavelengths ? interpolated(value, *point.wavelengths) : value;
    }
    bool reads_image() const { return texture_ && texture_->reads_image(); }

  private:
    static FresnelValue possible(const FresnelValue& value) {
        return {limited(value.eta, 1e-3f, 1e4f), limited(value.k, 0, 1e4f), value.conductor};
    }
    /// Constants between the wavelengths of R, G and B that `value` is given for; at the spectrum's
    /// ends those of the nearest.
    static FresnelValue interpolated(const FresnelValue& value, const Wavelengths& wavelengths);

    FresnelValue constant_;
    std::shared_ptr<const FresnelTexture> texture_;
};

}  // namespace lxs::shading
