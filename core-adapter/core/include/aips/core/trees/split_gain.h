// When a split of a learned tree is none.
#pragma once

namespace aips {

/// Least fall of a tree's mass by a split, as a share of it.
inline constexpr double kLeastSplitGain = 1e-4;

}  // namespace aips
