// How much a node still needs photons.
// Sources: Liu & Zheng 2014, eq. 2-4 and 8; Hachisuka, Jarosz & Jensen 2010 (bias of the estimate).
#pragma once

#include <span>

#include "aips/core/node.h"

namespace aips {

/// From a node's statistics to its feature error.
class ErrorCriterion {
  public:
    virtual ~ErrorCriterion() = default;
    /// The node's new error; finite and >= 0. Only ratios between nodes matter.
    virtual double error(const NodeView& view) const = 0;
};

/// The paper's criterion, progressive (eq. 8) in its second pass and later.
class PaperErrorCriterion final : public ErrorCriterion {
  public:
    /// `alpha` in [0, 1): share of the last pass's error in eq. 8; throws std::invalid_argument.
    explicit PaperErrorCriterion(double alpha = 0.4);
    /// Eq. 8. With fewer than two photons, which have no variance, the error stays as it is.
    double error(const NodeView& view) const override;

  private:
    double alpha_;
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
double corrected_variance(const PowerStatistics& powers, double bias);
/// Eq. 2: w * var * vol / N, clamped to finite values.
double node_error(double weight, double variance, double volume, double count);

}  // namespace aips
