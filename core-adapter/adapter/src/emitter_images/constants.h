// Tuned constants of emitters' images: each with its unit, what it balances, which experiment chose
// it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstddef>

namespace aips {

/// Most emitter paths of a pass. Unit: eye paths.
/// Balances: noise of emitters behind glass and in mirrors against that of all else.
/// Chosen by: reasoning: they are to be 10 to 20 per cent of the eye paths.
/// Supported by: no measurement.
inline constexpr double kEmitterPathShare = 0.15;

/// Emitter paths of a pass through an image that is all of its pixel's light; others have their
/// part of that. Unit: paths. Balances: noise of images against that of all else. Chosen by:
/// docs/notebook/2026-11-25-images-of-lamps.md. Supported by: one scene only: chess.
inline constexpr double kPathsPerImage = 8;

/// Emitter paths of a pass that are drawn where images are few. Unit: eye paths.
/// Balances: as that of an image.
/// Chosen by: measurement.
/// Supported by: glass-ball, sun-window.
inline constexpr double kSpareEmitterPaths = 0.03;

/// Then as those of one image, at most. Unit: paths.
/// Balances: as that of an image.
/// Chosen by: reasoning: beyond it other light is the noise.
/// Supported by: no measurement.
inline constexpr double kMostPathsPerImage = 256;

/// Largest image that has paths of its own: drawn by themselves they are not stratified over
/// pixels. With an emitter that takes the share c of a pixel eye paths have the variance c (1 - c),
/// and with r of these for each of them (c (1 - c) + r c) / (1 + r)^2, which falls from r = 0 on if
/// c < 1/2. Unit: pixels.
/// Balances: noise of small images against that of large ones.
/// Chosen by: reasoning: up to there more paths always lessen the variance.
/// Supported by: no measurement.
inline constexpr double kLargestImage = 0.5;

/// The darkest that a pixel is taken for where paths are sent by relative error. Unit: mean
/// luminances of the image.
/// Balances: relative error against absolute error.
/// Chosen by: reasoning: that of photons' scores.
/// Supported by: no measurement.
inline constexpr double kDarkestEmitterPixel = 0.5;

/// Relative variance of a pixel without an image from which on it is fully worth finding. Unit:
/// ratio.
/// Balances: searches for what no eye path meets against images that eye paths do well.
/// Chosen by: measurement.
/// Supported by: summerhouse, jewellery, chess, bathroom, car (every image alike in its place).
inline constexpr double kNoisyImage = 64;

/// Least part of its pixel's light that an image is taken for. Unit: share of 1.
/// Balances: images that matter against fireflies of those that hardly do.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr double kLeastImagePart = 0.05;

}  // namespace aips
