// What one run is asked to be.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study_file.h"

namespace bench {

/// Written to the run's file; two runs with the same settings and binaries are the same run.
struct RunSettings {
    std::string scene, scene_file, scene_sha1;
    std::uint32_t width_px = 0;   ///< 0: the scene's own
    std::uint32_t height_px = 0;  ///< 0: in proportion to the width
    std::string method, variant, integrator;
    std::string sampler;           ///< "": the scene's own
    std::vector<std::string> set;  ///< integrator.parameter=value
    std::uint64_t seed = 1;
    unsigned threads = 0;               ///< 0: all processors
    std::vector<double> budgets_s;      ///< may be empty if there are `passes`
    std::vector<std::uint64_t> passes;  ///< snapshots after these numbers of passes, ascending
    std::string clock = "both";         ///< which clocks have to pass the budgets: both, cpu, wall
};

Json to_json(const RunSettings& settings);
RunSettings run_settings_from(const Json& json);

/// SCENE.METHOD.VARIANT.sSEED: the stem of all of the run's files.
std::string run_name(const RunSettings& settings);

/// What the process that renders is told: `aips-bench render-one JOB.json`.
struct RenderJob {
    RunSettings settings;
    std::string images;       ///< snapshot K is IMAGES.K.exr
    bool png = false;         ///< a PNG beside each EXR
    bool final_only = false;  ///< one snapshot, at the end
    std::string result;       ///< JSON file for what was measured
};

Json to_json(const RenderJob& job);
RenderJob render_job_from(const Json& json);

}  // namespace bench
