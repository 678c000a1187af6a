// Tuned constants of emitters' images: each with its unit, what it balances, which experiment chose
// it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstddef>

namespace aips {

/// Most emitter paths of a pass. Unit: eye paths.
/// Balances: noise of emitters behind glass and in mirrors against that of all else.
/// Chosen by: measurement.
/// Supported by: chess, jewellery, car, summerhouse, bathroom, glass-ball, sun-window, room (0.15
///   in its place).
inline constexpr double kEmitterPathShare = 0.1;

/// Emitter paths of a pass through an image that is all of its pixel's light; others have their
/// part of that. Unit: paths. Balances: noise of images against that of all else. Chosen by:
/// measurement. Supported by: chess, jewellery, car, summerhouse, bathroom, glass-ball, sun-window,
///   room (8, and 256 where images are few, in its place).
inline constexpr double kPathsPerImage = 64;

/// Largest image that has paths of its own: drawn by themselves they are not stratified over
/// pixels. With an emitter that takes the share c of a pixel eye paths have the variance c (1 - c),
/// and with r of these for each of them (c (1 - c) + r c) / (1 + r)^2, which falls from r = 0 on if
/// c < 1/2. Unit: pixels.
/// Balances: noise of small images against that of large ones.
/// Chosen by: reasoning: up to there more paths always lessen the variance.
/// Supported by: no measurement.
inline constexpr double kLargestImage = 0.5;

/// Least part of its pixel's light that an image is taken for. Unit: share of 1.
/// Balances: images that matter against fireflies of those that hardly do.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr double kLeastImagePart = 0.05;

}  // namespace aips
