// Tuned constants of searches for lamps: each with its unit, what it balances, which experiment
// chose it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstddef>

namespace aips {

/// Share of searches that start around images that are known, once there are some. Unit: share
/// of 1. Balances: images close to others against those by themselves. Chosen by:
/// docs/notebook/2026-11-25-images-of-lamps.md. Supported by: one scene only: chess.
inline constexpr float kNearKnown = 0.5f;

/// How far from their middles. Unit: pixels.
/// Balances: as that of their share.
/// Chosen by: docs/notebook/2026-11-25-images-of-lamps.md.
/// Supported by: one scene only: chess.
inline constexpr float kNearReach = 3;

/// First step by which derivatives are taken. Unit: pixels.
/// Balances: rounding against what lies within a step.
/// Chosen by: reasoning: single precision tells a thousandth of it apart.
/// Supported by: no measurement.
inline constexpr double kFirstDifference = 0.01;

/// Most steps of a search. Unit: steps.
/// Balances: rays against lamps that are hard to find.
/// Chosen by: reasoning: near a root each step doubles the digits.
/// Supported by: no measurement.
inline constexpr int kMostSearchSteps = 8;

/// Longest step. Unit: pixels.
/// Balances: few steps against steps off the surface.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr double kLongestStep = 2;

/// Most that a step is tried, half as long each time. Unit: tries.
/// Balances: rays against searches given up.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr int kMostHalvedSteps = 4;

/// A step counts if what it misses the lamp by has come down to this share. Unit: share of 1.
/// Balances: rays against searches given up.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr double kNearerBy = 0.9;

/// Farthest that a search goes from where it started. Unit: pixels.
/// Balances: lamps found from afar against those that others will find.
/// Chosen by: reasoning: others start there.
/// Supported by: no measurement.
inline constexpr double kFarthestRoot = 6;

/// Farthest that the first derivative may tell a lamp to be. Unit: pixels.
/// Balances: searches that fail against lamps that others will find.
/// Chosen by: reasoning: others start there.
/// Supported by: no measurement.
inline constexpr double kFarthestStart = 3;

/// Most searches from one place, through different surfaces or for different lamps. Unit: searches.
/// Balances: rays against small images; the largest are searched first.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr std::size_t kMostTries = 4;

/// Most lamps that one place is asked for. Unit: lamps.
/// Balances: time against lamps found late.
/// Chosen by: reasoning: more are drawn by their power.
/// Supported by: no measurement.
inline constexpr std::size_t kMostLampsOfPlace = 4;

/// A lamp is reached where its point is missed by less. Unit: radii of the lamp as seen from there.
/// Balances: rays against how well its image's place is known.
/// Chosen by: reasoning: the middle comes from other points of the lamp.
/// Supported by: no measurement.
inline constexpr double kLampReached = 0.5;

/// Points of a lamp that tell how large its image is. Unit: points.
/// Balances: an image's shape against time.
/// Chosen by: reasoning: no ray is cast for them.
/// Supported by: no measurement.
inline constexpr unsigned kLampPoints = 16;

/// Half axes of an image. Unit: standard deviations of the points of the lamp.
/// Balances: corners and curved images against paths that miss.
/// Chosen by: reasoning: a rectangle's corners are at 2.45.
/// Supported by: no measurement.
inline constexpr double kImageSize = 2.7;

/// What choices that show an image are widened by, as probabilities of ways differ over it. Unit:
/// probability.
/// Balances: choices that are missed against paths that take others.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr float kChoiceMargin = 0.02f;

/// Paths that look through an image before it is taken. Unit: paths.
/// Balances: rays against images in which nothing is seen.
/// Chosen by: reasoning: none on record.
/// Supported by: no measurement.
inline constexpr unsigned kImageLooks = 4;

}  // namespace aips
