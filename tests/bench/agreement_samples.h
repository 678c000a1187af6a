// Samples of block means for tests of agreement: a method's runs, and a scene's references.
#pragma once

#include <filesystem>

#include "method_agreement.h"
#include "run_group.h"

namespace bench {

/// The snapshots that a group's runs took for the study's largest budget, on the clock that ended
/// them. Runs that failed are left out. `summary` is that of the study in `folder`.
SeedBlocks blocks_of_runs(const std::filesystem::path& folder, const Json& summary,
                          const RunGroup& group);

/// startradius of the group's runs in pixel footprints; nothing without runs or radius. Throws
/// StudyError if its runs differ in it, or if they let it shrink.
std::optional<double> radius_of_runs(const Json& summary, const RunGroup& group);

/// The chunks of images 1 and 2 of a reference.json.
BlockSample blocks_of_references(const Json& metadata);

/// Means over those chunks of startradius^2 and startradius, 0 being that of images without radius.
BiasFactors reference_radii(const Json& metadata);

}  // namespace bench
