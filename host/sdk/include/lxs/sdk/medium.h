// What fills the space between surfaces: a medium, homogeneous or varying in space.
//
// References: Henyey & Greenstein 1941, "Diffuse radiation in the galaxy"; Wilkie et al. 2014,
// "Hero wavelength spectral sampling" (a distance or direction is drawn for one channel and weighed
// by the mean density over channels, which bounds the weights).
#pragma once

#include <optional>
#include <vector>

#include "lxs/sdk/index_curve.h"
#include "lxs/sdk/medium_field.h"
#include "lxs/sdk/types.h"

namespace lxs {

/// How far light goes in a medium before something happens to it (Medium::sample_flight).
struct Flight {
    float distance = 0;     ///< to the collision, or the segment's whole length
    bool collides = false;  ///< within the segment
    Rgb weight{1.0f};       ///< transmittance over `distance` / (density of the collision, or the
                            ///< probability of none); for collisions without scattering()
};

/// A direction drawn from the phase function.
struct PhaseSample {
    Vec3 direction{0.0f};  ///< unit, in which the light goes on
    float pdf = 0;         ///< per steradian
    Rgb weight{1.0f};      ///< phase / pdf
};

/// Of light on its way along a ray from `from` on: what has passed, or an estimate of it that is
/// right in the mean.
struct TransmittanceStep {
    float from = 0;
    Rgb passed{1.0f};
};

/// Absorbing, and scattering by Henyey and Greenstein's phase function. Coefficients are per unit
/// of distance and channel, >= 0. Of a medium that varies those that name no place are means.
class Medium {
  public:
    /// Absorbs only (LuxRender volume "clear"); `index` of refraction for glass2.
    Medium(const Rgb& absorption, float index)
        : Medium({absorption, Rgb(0.0f), Rgb(0.0f)}, IndexCurve{index}) {}
    Medium(const MediumCoefficients& coefficients, const IndexCurve& index) : index_(index) {
        set_coefficients(coefficients);
        own_emission_ = coefficients.emission;
        emits_ = !is_black(own_emission_);
    }

    /// A medium that varies; bound() comes before any light.
    Medium(std::shared_ptr<const MediumField> field, const Rgb& asymmetry, const IndexCurve& index)
        : extinction_(1.0f),
          scattering_(field->scatters() ? 1.0f : 0.0f),
          asymmetry_(asymmetry),
          emits_(field->emits()),
          index_(index),
          field_(std::move(field)) {}

    /// Whether it varies in space.
    bool varies() const { return field_ != nullptr; }
    /// Of one that varies: where it is.
    void bound(const Bounds& bounds, const FieldJobs& jobs);
    /// Of one that varies: of the pass; they outlive it.
    void set_wavelengths(const Wavelengths* wavelengths) {
        if (bounded_) bounded_->set_wavelengths(wavelengths);
    }

    MediumCoefficients coefficients() const {
        return {extinction_ - scattering_, scattering_, asymmetry_, emission_};
    }
    void set_coefficients(const MediumCoefficients& c) {
        extinction_ = c.absorption + c.scattering;
        scattering_ = c.scattering;
        asymmetry_ = c.asymmetry;
        emission_ = c.emission;
    }

    /// Share of light that goes `distance` without a collision (Beer-Lambert).
    Rgb transmittance(float distance) const;
    /// The same along a ray; where the medium varies, an estimate that is right in the mean.
    Rgb transmittance(const Vec3& origin, const Vec3& direction, float distance) const;
    /// The same for all distances up to `length` at once, of a medium that varies, drawn from `u`.
    void transmittance_steps(const Vec3& origin, const Vec3& direction, float length, float u,
                             std::vector<TransmittanceStep>& steps) const;
    const IndexCurve& index_curve() const { return index_; }
    /// Index for all wavelengths where light is not dispersed.
    float index() const { return index_.at(kMiddleNm); }
    /// Dims light: absorbs it or scatters it away.
    bool absorbs() const { return !is_black(extinction_); }
    const Rgb& extinction() const { return extinction_; }
    bool scatters() const { return !is_black(scattering_); }
    const Rgb& scattering() const { return scattering_; }
    /// At a place.
    Rgb scattering_at(const Vec3& position) const {
        return bounded_ ? bounded_->at(position).scattering : scattering_;
    }
    /// Sends light of its own.
    bool emits() const { return emits_; }
    /// Radiance that it sends per unit of distance, at a place: for R, G and B, whatever the pass
    /// has.
    Rgb emission_at(const Vec3& position) const {
        return bounded_ ? bounded_->emission(position) : own_emission_;
    }
    /// Light of its own that reaches the origin of a ray from its first `length`; where the medium
    /// varies, an estimate that is right in the mean.
    Rgb emitted(const Vec3& origin, const Vec3& direction, float length) const;

    /// Draws the distance to a collision on a segment (which may be infinite) from u in [0,1)^2.
    /// `carried` is what the path carries: channels that carry more decide more often.
    Flight sample_flight(float segment, const Rgb& carried, const Vec2& u) const;
    /// The same along a ray, in a medium that may vary.
    Flight sample_flight(const Vec3& origin, const Vec3& direction, float segment,
                         const Rgb& carried, const Vec2& u) const;

    /// Phase function per steradian for light that is turned by an angle of this cosine; integrates
    /// to 1 over the sphere.
    Rgb phase(float cosine) const;
    /// Draws the direction of light that came along `direction`, from u in [0,1)^2.
    PhaseSample sample_phase(const Vec3& direction, const Rgb& carried, const Vec2& u) const;
    /// Density per steradian of sample_phase for this cosine.
    float phase_pdf(float cosine, const Rgb& carried) const;

  private:
    Rgb extinction_, scattering_, asymmetry_;
    Rgb emission_{0.0f}, own_emission_{0.0f};  // the latter for R, G and B
    bool emits_ = false;
    IndexCurve index_;
    std::shared_ptr<const MediumField> field_;  // null: the same everywhere
    std::optional<BoundedField> bounded_;
};

}  // namespace lxs
