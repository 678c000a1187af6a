// What a study's runs say of its methods: errors against the baseline, bias and variance.
#pragma once

#include <filesystem>

#include "run_errors.h"

namespace bench {

/// "comparisons" of docs/reference/benchmark-files.md: every method against `study`'s baseline at
/// equal time. `runs` are measured and done.
Json compare_methods(const Json& runs, const Json& study);

/// "seed_statistics" of docs/reference/benchmark-files.md; reads the snapshots' images below
/// `folder`.
Json compare_seeds(const std::filesystem::path& folder, const Json& runs, const Json& study,
                   ReferenceCache& references);

}  // namespace bench
