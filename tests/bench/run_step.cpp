// One step of a study: a run is found or rendered, and measured.
#include "run_step.h"

#include <system_error>

#include "render_process.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

/// The run's document without errors; nothing if the user interrupted it.
std::optional<Json> render(const fs::path& folder, const RunSettings& settings,
                           const Build& build) {
    const std::string name = run_name(settings);
    RenderJob job;
    job.settings = settings;
    job.images = (folder / "images" / name).string();
    job.png = settings.seed == 1;
    job.result = (folder / "runs" / (name + ".measured")).string();
    const std::string started = utc_now();
    const ProcessEnd end =
        render_in_process(own_executable(), job, folder / "logs" / (name + ".log"));
    if (end.interrupted) return std::nullopt;
    Json run = run_document(folder, settings, build, started, end,
                            end.done ? read_json(job.result) : Json());
    std::error_code ignored;
    fs::remove(job.result, ignored);
    return run;
}

}  // namespace

std::optional<Json> carry_out_run(const fs::path& folder, const RunSettings& settings,
                                  const Build& build, ReferenceCache& references) {
    std::optional<Json> run = finished_run(folder, settings, build);
    bool changed = false;
    if (!run) {
        run = render(folder, settings, build);
        changed = true;
    }
    if (!run) return run;
    if (run->at("status") == "done") {
        const References* found = references.find(settings.scene, settings.scene_sha1,
                                                  settings.width_px, settings.height_px);
        changed = measure_run(folder, found, *run) || changed;
    }
    const fs::path file = run_file(folder, settings);
    if (changed) write_json(file, *run);
    (*run)["file"] = file.lexically_relative(folder).string();
    return run;
}

}  // namespace bench
