// `aips-bench run`: renders what a study lacks, measures and summarises it.
#include "run_command.h"

#include <fmt/format.h>

#include <set>
#include <system_error>

#include "method_check.h"
#include "photon_part.h"
#include "radius_check.h"
#include "render_process.h"
#include "run_errors.h"
#include "run_record.h"
#include "study_summary.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

/// Before anything is rendered: every method can be run with its overrides.
void check_methods(const RunRequest& request, const std::vector<RunSettings>& runs,
                   const MethodTable& table, const lxs::PluginLibrary& plugins,
                   lxs::ConsoleLog& log) {
    check_overrides(request.study.set, plugins);
    std::set<std::pair<std::string, std::string>> checked;
    for (const RunSettings& run : runs) {
        if (!checked.insert({run.method, run.variant}).second) continue;
        check_method(find_method(table.methods, run.method), run.set, plugins, request.folder, log);
    }
}

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

void warn_of_missing_references(const RunRequest& request, const std::vector<RunSettings>& runs,
                                ReferenceCache& references, lxs::ConsoleLog& log) {
    std::set<std::string> seen;
    for (const RunSettings& run : runs) {
        if (!seen.insert(run.scene).second) continue;
        if (references.find(run.scene, run.scene_sha1, run.width_px) == nullptr) {
            log.warning(
                fmt::format("scene \"{}\" has no references in '{}': its errors stay "
                            "unknown until `aips-bench reference` has made them and this "
                            "command is repeated",
                            run.scene, request.references.string()));
        }
    }
}

/// One step of the study. Returns the run's document, nothing if the user interrupted it.
std::optional<Json> carry_out(const fs::path& folder, const RunSettings& settings,
                              const Build& build, ReferenceCache& references) {
    std::optional<Json> run = finished_run(folder, settings, build);
    bool changed = false;
    if (!run) {
        run = render(folder, settings, build);
        changed = true;
    }
    if (!run) return run;
    if (run->at("status") == "done") {
        const References* found =
            references.find(settings.scene, settings.scene_sha1, settings.width_px);
        changed = measure_run(folder, found, *run) || changed;
    }
    const fs::path file = run_file(folder, settings);
    if (changed) write_json(file, *run);
    (*run)["file"] = file.lexically_relative(folder).string();
    return run;
}

}  // namespace

ExitCode run_study(const RunRequest& request, const MethodTable& table,
                   const lxs::PluginLibrary& plugins, const lxs::Interruption& interruption,
                   lxs::ConsoleLog& log) {
    std::vector<RunSettings> plan = plan_runs(request.study, table);
    for (RunSettings& run : plan) {
        if (request.photon_part) add_photon_part(run.integrator, plugins, run.set);
    }
    check_methods(request, plan, table, plugins, log);
    ReferenceCache references(request.references);
    warn_of_missing_references(request, plan, references, log);
    write_json(request.folder / "study.json", to_json(request.study));
    const Build build = this_build();
    Json runs = Json::array();
    bool failed = false;
    for (const RunSettings& settings : plan) {
        if (interruption.requested()) return ExitCode::Interrupted;
        log.info(fmt::format("run {} of {}: {}", runs.size() + 1, plan.size(), run_name(settings)));
        std::optional<Json> run = carry_out(request.folder, settings, build, references);
        if (!run) return ExitCode::Interrupted;
        if (run->at("status") == "failed") {
            log.error(fmt::format("{} failed: {}", run_name(settings),
                                  run->at("message").get<std::string>()));
            failed = true;
        }
        runs.push_back(*std::move(run));
    }
    const Json summary = summarise(request.folder, request.study, table, runs, references);
    for (const std::string& warning : radius_warnings(summary))
        log.warning(warning);
    write_json(request.folder / "summary.json", summary);
    return failed ? ExitCode::RunsFailed : ExitCode::Success;
}

}  // namespace bench
