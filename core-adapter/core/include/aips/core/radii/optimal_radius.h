// The radius that balances noise and bias of a progressive density estimate, and the probe that
// measures what it depends on.
//
// Source: Kaplanyan & Dachsbacher 2013, "Adaptive progressive photon mapping", where it is a
// pixel's bandwidth that minimises the asymptotic mean squared error. Derived anew for a disc
// kernel, whose estimate over N photon paths with radius r has
//
//     bias      r^2 / 8 * Laplacian      (mean of squared offsets in a disc: r^2 / 4 a direction),
//     variance  q / (pi r^2 N),          q: density of the squared contributions of photons,
//
// the latter because the photons of many independent paths are nearly a Poisson process. The
// paper's variance and density of photons, two estimates, are one here: q.
#pragma once

#include <array>
#include <cstddef>

#include "aips/core/radii/constants.h"

namespace aips {

/// Radius of the pass after which `paths` photon paths have been shot, if the image is the mean
/// over equal passes and each had the radius that this function gave for it. Such radii fall with
/// paths^(-1/6); r^2 = c i^(-1/3) in pass i of n leaves
///
///     bias 3/2 c n^(-1/3) * Laplacian / 8,    variance 3/4 q / (pi c N) n^(-2/3),
///
/// whose squared sum is least for c^3 = 32 q / (3 pi N Laplacian^2), whatever n. (One radius for
/// all n N paths would be 3^(1/6) times as large.) `second_moment` is q, `squared_laplacian` of the
/// density in the same unit of contribution, per scene unit to the fourth; both > 0.
double optimal_radius(double second_moment, double squared_laplacian, double paths);

/// Sums over the photons within the radius of a probe: a disc in which a density and its curvature
/// are measured.
struct ProbeSums {
    double squares = 0;  ///< of contributions
    /// [scale]: of contributions times curvature_weight, within the scale's disc.
    std::array<double, kProbeScales> curvature{};
    /// [scale]: of the squares of those terms, which is the variance of `curvature`.
    std::array<double, kProbeScales> uncertainty{};

    /// A photon that contributes `value`, at `share` of the squared radius from the centre.
    void add(double value, double share);
    /// As if all values had been multiplied by `factor`.
    void scale(double factor);
};

/// What weighs a photon at `share` (0..1) of a disc's squared radius, so that the mean of weighted
/// contributions is the Laplacian times the squared radius: share is uniform over a disc, and
/// g + Laplacian r^2 share / 4 is what a density looks like around the centre, other second-order
/// terms cancelling. Of all weights that are exact for it this has the least variance where the
/// density is even.
constexpr double curvature_weight(double share) {
    return 24 * (2 * share - 1);
}

/// A Laplacian measured, and the square of its standard error.
struct LaplacianEstimate {
    double value = 0, error2 = 0;
};

/// What probes know of a density, per photon path.
struct ProbeEstimate {
    double second_moment = 0;                                 ///< q
    std::array<LaplacianEstimate, kProbeScales> laplacian{};  ///< [scale]
};

/// From the sums of one probe with `radius` over `paths` photon paths.
ProbeEstimate probe_estimate(const ProbeSums& sums, double radius, double paths);

/// The squared Laplacian to reckon with. The error of a radius is linear in it, so its expected
/// value counts: value^2 + error2 of the widest disc. Light that changes within that disc has more
/// curvature than it can tell; narrower discs, which are far noisier, take over where they are sure
/// (two standard errors) of more.
double expected_squared_laplacian(const ProbeEstimate& estimate);

}  // namespace aips
