// What `aips-bench agreement` might find in the synthetic study: every verdict there is.
#pragma once

#include <filesystem>

#include "study_file.h"

namespace bench::test {

/// Of sppm to the references in the plain scene.
inline constexpr double kSyntheticRatio = 1.01, kSyntheticHalfInterval = 0.015;

/// Writes FOLDER/study/agreement.json beside that `summary`. In the plain scene sppm and "better"
/// agree with the references, "worse" differs by 20 %, most in block (0, 5); "better" agrees with
/// sppm, and "worse" is open. In the other scene sppm is open, "better" misses what attacks the
/// page, and "worse" has not been tested. sppm alone claims a bias, -1.3 %.
void write_synthetic_agreement(const std::filesystem::path& folder, const Json& summary);

}  // namespace bench::test
