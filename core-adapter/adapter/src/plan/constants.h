// Tuned constants of what is planned: each with its unit, what it balances, which experiment chose
// it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstdint>

namespace aips {

/// Share of unguided photon paths that come near what is seen from which on photons go without the
/// adaptive guide. Unit: share of 1.
/// Balances: the cost of learning in lit rooms against what a guide gains elsewhere.
/// Chosen by: measurement.
/// Supported by: magic-lamp, room, cornell-box, ajar-door, summerhouse, eight more.
inline constexpr double kNearWithoutGuide = 1.0 / 3;

/// Fewest photon paths of a pass that is chosen. Unit: photon paths.
/// Balances: passes of the eye against iterations that keep no thread busy.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::uint32_t kFewestPerPass = 1u << 12;

/// What a pass after the first choice counts for, those before, of few photons, for 1; 1 too with a
/// guide in small images, which shoots more at first. Unit: ratio.
/// Balances: noise of the first passes against the photons that they bring.
/// Chosen by: measurement.
/// Supported by: glass-ball, hall, summerhouse (2 and 64 in its place); hall, sun-window,
///   glass-ball, prism, ajar-door (2 with a guide in small images).
inline constexpr double kChosenWeight = 8;

/// The same of a guide in large images, whose passes it begins with as many photons as eye paths:
/// it is given more at first, and what it shoots while it learns counts for less anyway. Unit:
/// ratio.
/// Balances: noise of the first passes against the photons that they bring.
/// Chosen by: measurement.
/// Supported by: hall, glass-ball (1 and 8 in its place).
inline constexpr double kChosenWeightOfAGuide = 2;

/// Greatest cost of photons over the eye's: beyond it no more than a tenth could be gained. Unit:
/// ratio. Balances: the eye's noise against that of photons. Chosen by: reasoning: what is left to
/// gain beyond it. Supported by: no measurement.
inline constexpr double kGreatestRatio = 10;

/// Work of an eye ray, and of what else an eye path takes: shading, film, search. Unit: about 0.3
/// us. Balances: the choice of the photons per pass: time of the eye against that of photons.
/// Chosen by: docs/notebook/2026-11-23-costs-of-a-pass.md. Supported by: 13 scenes.
inline constexpr double kEyeRayWork = 1.1;

/// Work of a photon's ray, of its bounce, of a guided emission, and of a path, vertex or photon
/// that is learned from. Unit: about 0.3 us. Balances: as that of an eye ray. Chosen by:
/// docs/notebook/2026-11-23-costs-of-a-pass.md. Supported by: 13 scenes.
inline constexpr double kRayWork = 0.8;

/// Work of a photon gathered. Unit: about 0.3 us. Balances: as that of an eye ray. Chosen by:
/// docs/notebook/2026-11-23-costs-of-a-pass.md. Supported by: 13 scenes.
inline constexpr double kGatheredWork = 0.6;

/// Work of a photon that a beam gathers. Unit: about 0.3 us. Balances: as that of an eye ray, and
/// how many photons in media a beam leaves out. Chosen by: measurement. Supported by: six scenes
/// with fog, dust, water and milk (0.07 to 0.25).
inline constexpr double kGatheredInMediaWork = 0.15;

/// Work of a bounce whose direction a guide drew. Unit: about 0.3 us. Balances: as that of an eye
/// ray. Chosen by: docs/notebook/2026-11-23-costs-of-a-pass.md. Supported by: 13 scenes.
inline constexpr double kGuidedBounceWork = 1.8;

/// Greatest share of the eye in light that both carry: what photons bring of it still tells what
/// they would. Unit: share of 1. Balances: a share that is best against knowing when it no longer
/// is. Chosen by: reasoning: photons then carry a thousandth of that light's variance. Supported
/// by: no measurement.
inline constexpr double kMostEyeShare = 0.96875;

/// Where continued paths brought less than this share of what photons did, they missed what is
/// rare, and what is missing tells their variance. Unit: share of 1. Balances: light that paths
/// seldom meet against the bias of radii. Chosen by: reasoning: radii are off by less. Supported
/// by: no measurement.
inline constexpr double kSeldomMet = 0.75;

/// Continued paths that found light, in effect, from which a leaf is judged. Unit: eye paths.
/// Balances: decisions soon against places whose light paths have not met at all.
/// Chosen by: measurement; that there is such a
///   number by docs/notebook/2026-11-25-who-carries-what.md.
/// Supported by: car, daylight (8 and 4 in its place); no difference beyond chance in open-ground,
///   sun-window, ajar-door, hall, pool, magic-lamp, summerhouse.
inline constexpr double kFoundByPaths = 2;

/// What is left of the eye's variance between two passes when many are joined, as eye paths are
/// stratified from pass to pass. Unit: share of 1.
/// Balances: photons for light that they alone carry against eye paths.
/// Chosen by: docs/notebook/2026-11-25-who-carries-what.md.
/// Supported by: summerhouse, cornell-box, hall (1 in its place).
inline constexpr double kStratifiedEye = 0.35;

/// The same of continued paths: the first of their directions is stratified. Unit: share of 1.
/// Balances: eye paths against photons for light that both carry.
/// Chosen by: docs/notebook/2026-11-25-who-carries-what.md.
/// Supported by: summerhouse (1 in its place); no difference in five others.
inline constexpr double kStratifiedPaths = 0.5;

/// Work of a pass that shoots for each of its visible points, however many photons there are: it is
/// marked, has a radius, and is asked what lies around it. Unit: about 0.3 us. Balances: passes
/// without photons against light that only some passes have. Chosen by:
/// measurement. Supported by: summerhouse, car.
inline constexpr double kPointWork = 1.5;

/// Most passes of which one shoots. Unit: passes, a power of two. Balances: as that of a point's
/// work. Chosen by: reasoning: an eighth of that work is left. Supported by: no measurement.
inline constexpr std::uint32_t kMostTurns = 8;

/// Factor by which a plan may raise the photon paths of a pass. Unit: ratio.
/// Balances: soon at the best number against what few passes tell by chance.
/// Chosen by: reasoning: passes count alike, so that their numbers may change slowly only.
/// Supported by: no measurement.
inline constexpr double kGreatestRise = 2;

/// Factor by which it may lower them. Unit: ratio.
/// Balances: as that of the rise.
/// Chosen by: reasoning: as that of the rise.
/// Supported by: no measurement.
inline constexpr double kGreatestFall = 32;

}  // namespace aips
