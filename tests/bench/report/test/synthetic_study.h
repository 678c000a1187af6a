// A study whose every figure is known: errors that are power laws of time, images off by a constant
// factor.
#pragma once

#include <filesystem>

#include "study_file.h"

namespace bench::test {

/// Relative to `sppm`, the baseline: "better" has half its error, "worse" twice, at every time and
/// with every seed (but for a spread of 1 % between seeds); relMSE of sppm is 8 / seconds. Two
/// scenes, the name of one being an attack on the page; seeds 1 and 2; budgets 1, 2 and 4 s on both
/// clocks; both variants. The images have `kSyntheticWidth` x 30 pixels, those of "better" 10 % too
/// bright, of "worse" 20 % too dark. The photon part, in the plain scene alone, has the squares of
/// those factors: "better" a quarter of sppm's error, "worse" four times. In the plain scene's
/// images sppm and "better" have debug layers, "better" those of a guide too. Bias and variance are
/// made up: that of sppm is kSyntheticBias2, below 0.
inline constexpr int kSyntheticWidth = 40;
inline constexpr double kSyntheticBias2 = -0.00125;
inline constexpr const char* kPlainScene = "box";
inline constexpr const char* kNastyScene = "</script><img src=x onerror=alert(1)>";

/// Writes FOLDER/study (summary.json and images) and FOLDER/references; returns the summary.
Json write_synthetic_study(const std::filesystem::path& folder);

}  // namespace bench::test
