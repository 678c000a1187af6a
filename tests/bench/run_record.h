// A run's JSON file: made from what was measured, found again when a study is resumed.
#pragma once

#include <filesystem>
#include <optional>

#include "render_process.h"
#include "run_settings.h"

namespace bench {

inline constexpr const char* kRunSchema = "aips-bench-run-1";

/// The programs that render: runs of other builds are repeated.
struct Build {
    std::string revision;
    std::string binaries_sha1;
    bool accepts_others = false;  ///< runs of other builds count as done
};

/// This executable with the plugin modules beside it.
Build this_build();

/// processor, hardware_threads, system.
Json machine();

/// Date and time now, UTC, ISO 8601.
std::string utc_now();

/// DIR/runs/NAME.json
std::filesystem::path run_file(const std::filesystem::path& folder, const RunSettings& settings);

/// The run's file, if it is complete, of this build and of these settings.
std::optional<Json> finished_run(const std::filesystem::path& folder, const RunSettings& settings,
                                 const Build& build);

/// The run's document without errors; `measured` is null for a run that failed. Paths of snapshots
/// become relative to `folder`.
Json run_document(const std::filesystem::path& folder, const RunSettings& settings,
                  const Build& build, const std::string& started, const ProcessEnd& end,
                  const Json& measured);

}  // namespace bench
