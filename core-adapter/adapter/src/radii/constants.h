// Tuned constants of search radii: each with its unit, what it balances, which experiment chose it,
// and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstdint>

namespace aips {

/// Automatic start radius. Unit: footprints.
/// Balances: noise against blur.
/// Chosen by: docs/notebook/2026-11-23-radius-of-chains.md.
/// Supported by: hall, glass-ball (1 in its place); ajar-door, hall, sun-window
///   (docs/notebook/2026-11-23-adaptive-radius-bounds.md, 1 in its place, which the last one gains
///   by).
inline constexpr double kAutomaticRadius = 2;

/// The same where chains take the guide's place: next to none of other photons would be seen, all
/// of theirs are, and bias is most of the error that is left. Unit: footprints.
/// Balances: noise against blur.
/// Chosen by: docs/notebook/2026-11-23-radius-of-chains.md.
/// Supported by: one scene only: summerhouse (2, 0.7 and 0.5 in its place).
inline constexpr double kChainAutomaticRadius = 1;

/// Photon paths after which the radius schedule has made one step of Knaus and Zwicker (2011), and
/// probes have begun to shrink: a constant, so that methods with other numbers of photons per pass
/// keep equal radii at equal work. Unit: photon paths.
/// Balances: noise against blur.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr double kReferencePaths = 1e6;

/// Smallest radius that is the same for all of a pass. Unit: share of the scene's diagonal.
/// Balances: sharpness in wide scenes against radii that single precision does not resolve.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr double kMinRadiusShare = 1e-7;

/// Smallest radius of any visible point, beside that of its own coordinates. Unit: share of the
/// scene's diagonal.
/// Balances: sharpness near the origin of wide scenes against radii of nothing.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr double kLeastRadiusShare = 1e-9;

/// Before this pass all radii follow at once what probes find. Unit: passes.
/// Balances: time against radii that are late.
/// Chosen by: reasoning: from then on a pass brings a sixteenth of what is known, or less.
/// Supported by: no measurement.
inline constexpr std::uint64_t kRadiiRenewedUntil = 16;

/// Passes that shoot in which they all do later. Unit: passes.
/// Balances: as that of the first.
/// Chosen by: docs/notebook/2026-11-26-passes-without-photons.md.
/// Supported by: summerhouse, car, chess, glass-ball.
inline constexpr std::uint64_t kRadiiRenewedIn = 4;

/// Least radius that adapts. The schedule lets both bias and noise vanish with the photons shot, so
/// radii within a constant factor do, whatever probes say. Unit: scheduled radii.
/// Balances: edges of caustics against probes that err.
/// Chosen by: docs/notebook/2026-11-23-adaptive-radius-bounds.md.
/// Supported by: no measurement (the greatest was varied, not the least).
inline constexpr double kLeastOfSchedule = 0.125;

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

/// One pixel of each square of so many by so many is probed in a pass. Unit: pixels.
/// Balances: time of probing against how soon curvature is known.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::uint32_t kProbeStep = 4;

}  // namespace aips
