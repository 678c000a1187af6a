// Tuned numbers of the denoiser.
#pragma once

namespace lxs::denoising {

/// How far a pixel looks for others like it. Unit: pixels. Balances: noise left where there are
/// many against time, which grows with its square. Chosen by: relMSE in 19 scenes after 5 seconds,
/// 5 to 15.
inline constexpr int kReach = 11;

/// Surroundings that are compared reach this far. Unit: pixels. Balances: tests of more pixels,
/// which are surer, against details that differ in one. Chosen by: the same, 1 and 2.
inline constexpr int kSurroundings = 1;

/// Squared difference that joins pixels by half, in units of the sum of both variances. Unit: 1.
/// Balances: noise against blur. Chosen by: the same, 0.4 to 1, squared.
inline constexpr float kColorTolerance = 0.49f;

/// Likewise for guides. Unit: 1. Balances: noise against blurred texture. Chosen by: the same, 0.4
/// to 1.5, squared.
inline constexpr float kGuideTolerance = 1.44f;

/// How far a half may exceed the other, in standard deviations of the other around the pixel. Unit:
/// 1. Balances: single bright paths against light lost. Chosen by: the same, 1.5 to 3 and none.
inline constexpr float kMostExcess = 2;

/// A pixel's variance is the mean of those around, but no more than its own times this. Unit: 1.
/// Balances: a variance from few passes against dark pixels beside bright ones. Chosen by: the
/// same, 2 to 10 and no limit.
inline constexpr float kMostOfOwnVariance = 10;

}  // namespace lxs::denoising
