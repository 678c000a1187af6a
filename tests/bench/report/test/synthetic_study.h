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
/// bright, of "worse" 20 % too dark.
inline constexpr int kSyntheticWidth = 40;
inline constexpr const char* kPlainScene = "box";
inline constexpr const char* kNastyScene = "</script><img src=x onerror=alert(1)>";

/// Writes FOLDER/study (summary.json and images) and FOLDER/references; returns the summary.
Json write_synthetic_study(const std::filesystem::path& folder);

}  // namespace bench::test
