// `aips-bench run`: renders what a study lacks, measures and summarises it.
#include "run_command.h"

#include <fmt/format.h>

#include <set>

#include "method_check.h"
#include "photon_part.h"
#include "radius_check.h"
#include "run_errors.h"
#include "run_step.h"
#include "study_summary.h"

namespace bench {
namespace {

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
        std::optional<Json> run = carry_out_run(request.folder, settings, build, references);
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
