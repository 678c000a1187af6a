// Tuned constants of searches for emitters: each with its unit, what it balances, which experiment
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

}  // namespace aips
