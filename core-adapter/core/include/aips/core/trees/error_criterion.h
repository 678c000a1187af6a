// How much a node still needs photons.
// Sources: Liu & Zheng 2014, eq. 2-4 and 8; Hachisuka, Jarosz & Jensen 2010 (bias of the estimate).
#pragma once

#include <span>

#include "aips/core/trees/node.h"

namespace aips {

/// From a node's statistics to its feature error.
class ErrorCriterion {
  public:
    virtual ~ErrorCriterion() = default;
    /// The node's new error; finite and >= 0. Only ratios between nodes matter.
    virtual double error(const NodeView& view) const = 0;
    /// What a node remembers of a photon: of its power (luminance) or of its score (what it
    /// contributed to the image, in squared units of power). Infinite at most if one of them is.
    virtual float value(float power, double /*score*/) const { return power; }
    /// Whether it asks for scores.
    virtual bool needs_scores() const { return false; }
};

/// Eq. 8: from its second pass on a node's error is mixed with that of the last pass.
class ProgressiveCriterion : public ErrorCriterion {
  public:
    /// With fewer than two photons, which have no variance, the error stays as it is.
    double error(const NodeView& view) const final;

  protected:
    /// `alpha` in [0, 1): share of the last pass's error; throws std::invalid_argument.
    explicit ProgressiveCriterion(double alpha);
    /// The error that this pass shows, of two photons or more.
    virtual double error_of_pass(const NodeView& view) const = 0;

  private:
    double alpha_;
};

/// The paper's criterion: eq. 2, of the photons' powers.
class PaperErrorCriterion final : public ProgressiveCriterion {
  public:
    explicit PaperErrorCriterion(double alpha = 0.4) : ProgressiveCriterion(alpha) {}

  private:
    double error_of_pass(const NodeView& view) const override;
};

/// Beyond the paper: the image's error. A node's error is the root of the mean score of its
/// photons, each divided by its squared power: what a photon of unit power that lands there adds
/// to the root of the image's squared error, and so the density that photons ought to have there if
/// this photon were their last.
class ImageErrorCriterion final : public ProgressiveCriterion {
  public:
    explicit ImageErrorCriterion(double alpha = 0.4) : ProgressiveCriterion(alpha) {}
    float value(float power, double score) const override;
    bool needs_scores() const override { return true; }

  private:
    double error_of_pass(const NodeView& view) const override;
};

/// Triweight kernel over the unit disk, K(s) = (4 / pi) (1 - s^2)^3; integrates to 1.
double triweight(double s);
/// Its Laplacian in the plane, 12 (4 / pi) (1 - s^2) (3 s^2 - 1); 0 for s >= 1.
double triweight_laplacian(double s);
/// Its second moment along one axis, the integral of x^2 K.
inline constexpr double kTriweightSecondMoment = 0.1;

/// B of eq. 3, in the unit of a photon's power.
double bias_correction(std::span<const NodePhoton> photons);
/// var of eq. 4, in squared units of power; needs two photons or more.
double corrected_variance(const ValueStatistics& powers, double bias);
/// Eq. 2: w * var * vol / N, clamped to finite values.
double node_error(double weight, double variance, double volume, double count);

}  // namespace aips
