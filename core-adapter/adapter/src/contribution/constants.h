// Tuned constants of what photons contribute: each with its unit, what it balances, which
// experiment chose it, and what supports it. docs/build-on/constants.md is made from these
// comments.
#pragma once

#include <cstdint>

namespace aips {

/// Most photons that one is split into. Unit: photons.
/// Balances: noise behind narrow openings against photons that crowd one place.
/// Chosen by: docs/notebook/2026-11-24-where-photons-are-split.md.
/// Supported by: ajar-door, pool, glass-ball, hall, sun-window (16 in its place).
inline constexpr float kMostPhotons = 4;

/// Least probability with which a photon survives. Each photon that goes on carries 1 / (photons
/// going on) of the power, so that no vertex multiplies it by more than 1 / this. Unit:
/// probability.
/// Balances: fireflies against rays that nobody sees.
/// Chosen by: reasoning: the bound on fireflies, 20 at a vertex.
/// Supported by: no measurement.
inline constexpr float kMinSurvival = 0.05f;

/// Cost of storing and gathering a photon, and of emitting it: gather and grid take about a third
/// of what tracing takes where photons are many, and an emission casts no ray. Unit: rays.
/// Balances: paths that land often, or end at once, against others.
/// Chosen by: measurement.
/// Supported by: LuxRender's Cornell box, cornell-box, glass-ball.
inline constexpr double kPhotonCost = 0.3;

/// Weight of a pixel where nothing is known of the image: below the mean of 1, since those scores
/// are for no pixel in particular, and the next ones shall soon outweigh them. Unit: mean weights.
/// Balances: learning from the first pass against scores that outlive it.
/// Chosen by: docs/notebook/2026-11-23-one-scale-for-scores.md.
/// Supported by: sun-window, hall, glass-ball.
inline constexpr float kUnknownWeight = 0.1f;

/// Half width of the box that pixels are blurred over in the first pass; it falls with the root of
/// the passes. Unit: pixels.
/// Balances: noise of single pixels against edges of light.
/// Chosen by: reasoning: photons are few in the first passes.
/// Supported by: no measurement.
inline constexpr int kFirstBlur = 12;

/// Half width of the box that pixels are blurred over in late passes. Unit: pixels.
/// Balances: noise of single pixels against edges of light.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr int kLastBlur = 2;

/// What a pixel counts for at most in the trimmed noise of a pass. Unit: relative variance.
/// Balances: photons for all pixels against eye paths for those few that meet emitters in glass.
/// Chosen by: docs/notebook/2026-11-25-who-carries-what.md.
/// Supported by: glass-ball, chess, room.
inline constexpr double kMostOfAPixel = 4;

/// What a pixel counts for at most in the noise of what eye paths bring by themselves, as a mean
/// over passes. Unit: relative variance.
/// Balances: light that few passes meet anywhere against pixels that no number of passes helps.
/// Chosen by: measurement.
/// Supported by: prism and daylight (4, 64 and no end in its place); no difference in car,
/// bathroom,
///   summerhouse.
inline constexpr double kMostOfOwnLight = 16;

/// eps over the mean luminance where it is decided who carries light. Unit: share of 1.
/// Balances: dark pixels' relative errors against bright ones' squared ones.
/// Chosen by: docs/notebook/2026-11-25-who-carries-what.md.
/// Supported by: chess, room, hall, glass-ball (0.5 in its place).
inline constexpr double kDarkestShareOfSharing = 0.1;

}  // namespace aips
