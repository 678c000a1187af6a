// How exactly Embree's kernels calculate.
#pragma once

namespace lxs {

/// Largest relative error of one rounding: single precision, to nearest.
inline constexpr double kKernelRoundoff = 0x1p-24;

}  // namespace lxs
