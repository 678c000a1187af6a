// Tuned constants of gather radii: each with its unit, what it balances, which experiment chose it,
// and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstdint>

namespace aips {

/// Automatic start radius. Unit: footprints.
/// Balances: noise against blur.
/// Chosen by: measurement.
/// Supported by: hall, glass-ball (1 in its place); ajar-door, hall, sun-window
///   (docs/notebook/2026-11-23-adaptive-radius-bounds.md, 1 in its place, which the last one gains
///   by).
inline constexpr double kAutomaticRadius = 2;

/// Photon paths after which the radius schedule has made one step of Knaus and Zwicker (2011), and
/// probes have begun to shrink: a constant, so that methods with other numbers of photons per pass
/// keep equal radii at equal work. Unit: photon paths.
/// Balances: noise against blur.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr double kReferencePaths = 1e6;

/// Least radius that adapts. The schedule lets both bias and noise vanish with the photons shot, so
/// radii within a constant factor do, whatever probes say. Unit: scheduled radii.
/// Balances: edges of caustics against probes that err.
/// Chosen by: docs/notebook/2026-11-23-adaptive-radius-bounds.md.
/// Supported by: no measurement (the greatest was varied, not the least).
inline constexpr double kLeastOfSchedule = 0.125;

/// Share of what is known of a pixel's blur that each pass makes forgotten: radii change meanwhile.
/// Unit: share.
/// Balances: noise of what is known against blur of radii that are no more.
/// Chosen by: docs/notebook/2026-11-28-radii-that-blur-narrows.md.
/// Supported by: prism, glass-ball, ring (0.02 in its place).
inline constexpr double kBlurForgotten = 0.05;

/// Passes that saw a pixel from which on they are compared with each other, to tell how noisy what
/// they tell of its blur is. Unit: passes.
/// Balances: radii that adapt soon against radii that shrink on noise alone.
/// Chosen by: docs/notebook/2026-11-28-radii-that-blur-narrows.md.
/// Supported by: no measurement.
inline constexpr std::uint32_t kBlurComparedFrom = 4;

/// Share of what passes differ by in a pixel that is taken for noise of its blur; eye paths have
/// some of it, which go to other places each. Unit: share.
/// Balances: blur against radii that shrink on photons that come together.
/// Chosen by: docs/notebook/2026-11-28-radii-that-blur-narrows.md.
/// Supported by: prism, glass-ball, sun-window, hall (0 and 1 in its place).
inline constexpr double kBlurApart = 0.5;

/// Blur narrows a pixel's radii where, squared, it is more than so many times the variance of the
/// mean over passes; half as large is best for a bias as of a disc. Unit: ratio.
/// Balances: blur against noise.
/// Chosen by: docs/notebook/2026-11-28-radii-that-blur-narrows.md.
/// Supported by: prism, glass-ball, ring (4 in its place).
inline constexpr double kBlurTooLarge = 2;

/// And where the pass itself shows more than this share of it. Unit: share.
/// Balances: blur that noise hides in single passes against discs that narrow past its end.
/// Chosen by: docs/notebook/2026-11-28-radii-that-blur-narrows.md.
/// Supported by: prism, sun-window (0.25 in its place).
inline constexpr double kBlurStillSeen = 0.5;

/// And widens them again where it is less than so many times that variance. Unit: ratio.
/// Balances: blur against noise.
/// Chosen by: docs/notebook/2026-11-28-radii-that-blur-narrows.md.
/// Supported by: no measurement.
inline constexpr double kBlurSmall = 0.5;

/// Factor of a pixel's radii for each pass whose blur is too large. Unit: factor.
/// Balances: how soon blur goes against radii that are narrowed for nothing.
/// Chosen by: docs/notebook/2026-11-28-radii-that-blur-narrows.md.
/// Supported by: no measurement.
inline constexpr double kNarrowingStep = 0.93;

/// And where it is small. Unit: factor.
/// Balances: as that of narrowing, more slowly, as noise comes and goes.
/// Chosen by: docs/notebook/2026-11-28-radii-that-blur-narrows.md.
/// Supported by: no measurement.
inline constexpr double kWideningStep = 1.021;

/// Least factor of a pixel's radii for its blur: within a constant factor of the schedule. Unit:
/// factor.
/// Balances: edges of caustics against noise.
/// Chosen by: docs/notebook/2026-11-28-radii-that-blur-narrows.md.
/// Supported by: no measurement.
inline constexpr double kLeastNarrowing = 0.08;

/// Greatest radius that adapts. Wider ones brighten the rims of balls that scatter most at grazing
/// angles (velvet), by 20 % at 2, 120 % at 4. Unit: scheduled radii.
/// Balances: noise of even light against rims and blur.
/// Chosen by: docs/notebook/2026-11-23-adaptive-radius-bounds.md.
/// Supported by: glass-ball, sun-window, ajar-door, hall, chess, cornell-box, summerhouse,
///   LuxRender's material-velvet (4 in its place).
inline constexpr double kGreatestOfSchedule = 2;

/// Radius of the first probes. Wider than what it leads to: the Laplacian from a disc is so noisy
/// (its error, as bias, is 1.7 times the error of the disc's own estimate) that radii measured
/// within themselves would shrink on noise alone. Unit: scheduled radii.
/// Balances: noise of the Laplacian against light that changes within the probe.
/// Chosen by: reasoning: wider than the radius that it leads to.
/// Supported by: no measurement.
inline constexpr double kProbeRadius = 4;

/// Probes shrink with this power of the photons. Unit: exponent.
/// Balances: noise of the Laplacian against light that changes within the probe.
/// Chosen by: reasoning: the best power for a second derivative of a density in the plane.
/// Supported by: no measurement.
inline constexpr double kProbePower = -0.1;

}  // namespace aips
