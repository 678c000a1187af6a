// `aips-bench paper`: the figures of Liu and Zheng 2014 redone.
#include "paper_command.h"

#include <fmt/format.h>

#include <cstdio>
#include <set>
#include <span>

#include "experiment_errors.h"
#include "experiment_plan.h"
#include "lxs/host/failure.h"
#include "lxs/imaging/atomic_file.h"
#include "method_check.h"
#include "paper_text.h"
#include "photon_distribution.h"
#include "reference_command.h"
#include "run_record.h"
#include "run_step.h"
#include "seed_variance.h"

namespace bench {
namespace {

/// What all steps of the command need.
struct Context {
    const PaperRequest& request;
    const MethodTable& table;
    const lxs::PluginLibrary& plugins;
    const lxs::Interruption& interruption;
    lxs::ConsoleLog& log;
};

const char* kind_name(ExperimentKind kind) {
    switch (kind) {
        case ExperimentKind::Passes:
            return "passes";
        case ExperimentKind::Convergence:
            return "convergence";
        case ExperimentKind::Time:
            return "time";
        case ExperimentKind::Distribution:
            break;
    }
    return "distribution";
}

std::vector<BenchScene> scenes_of(const PaperRequest& request, const Experiment& experiment) {
    std::vector<BenchScene> scenes;
    for (const PaperScene& scene : experiment.scenes)
        scenes.push_back(find_scene(scene.name, request.scene_table, request.scene_folder));
    return scenes;
}

/// Before anything is rendered: this build can run every case.
void check_cases(const Context& context, const std::vector<RunSettings>& plan) {
    std::set<std::string> checked;
    for (const RunSettings& run : plan) {
        if (!checked.insert(run.method).second) continue;
        const Method method{run.method, "", run.integrator, run.sampler, {}, true};
        check_method(method, run.set, context.plugins, context.request.folder, context.log);
    }
}

/// False if it was interrupted. Differing references are said by make_references.
bool make_missing_references(const Context& context, const Experiment& experiment) {
    ReferenceRequest reference;
    reference.scenes = scenes_of(context.request, experiment);
    reference.seconds = context.request.reference_seconds;
    reference.up_to = true;
    reference.threads = context.request.threads;
    reference.width_px = experiment.width_px;
    reference.height_px = experiment.height_px;
    reference.root = context.request.references;
    return make_references(reference, context.table, context.plugins, context.interruption,
                           context.log) != ExitCode::Interrupted;
}

Json distributions(const Context& context, const Experiment& experiment, const Json& runs,
                   ReferenceCache& references) {
    Json list = Json::array();
    if (experiment.kind != ExperimentKind::Distribution) return list;
    for (const BenchScene& scene : scenes_of(context.request, experiment)) {
        const References* found = references.find(scene.name, scene_checksum(scene.file),
                                                  experiment.width_px, experiment.height_px);
        if (found == nullptr) throw StudyError("scene \"" + scene.name + "\" has no references");
        list.push_back(photon_distribution({experiment, scene.name, runs, context.request.seeds,
                                            context.request.folder / experiment.study,
                                            context.request.folder / "images", *found}));
    }
    return list;
}

struct ExperimentRuns {
    Json runs = Json::array();
    bool failed = false, interrupted = false;
};

ExperimentRuns carry_out(const Context& context, const Experiment& experiment, const Build& build,
                         ReferenceCache& references) {
    const auto plan =
        plan_experiment(experiment, scenes_of(context.request, experiment), context.table,
                        context.request.seeds, context.request.threads);
    ExperimentRuns result;
    for (const RunSettings& settings : plan) {
        if (context.interruption.requested()) return {{}, false, true};
        context.log.info(fmt::format("figure {}, run {} of {}: {}", experiment.figure,
                                     result.runs.size() + 1, plan.size(), run_name(settings)));
        auto run =
            carry_out_run(context.request.folder / experiment.study, settings, build, references);
        if (!run) return {{}, false, true};
        if (run->at("status") == "failed") {
            context.log.error(fmt::format("{} failed: {}", run_name(settings),
                                          run->at("message").get<std::string>()));
            result.failed = true;
        }
        result.runs.push_back(*std::move(run));
    }
    return result;
}

Json experiment_document(const Context& context, const Experiment& experiment, const Json& runs,
                         ReferenceCache& references) {
    Json scenes = experiment_errors(experiment, runs, context.request.seeds);
    for (Json& scene : scenes) {
        add_seed_variance(experiment, runs, context.request.seeds,
                          context.request.folder / experiment.study, scene);
    }
    return {{"figure", experiment.figure},
            {"title", experiment.title},
            {"kind", kind_name(experiment.kind)},
            {"study", experiment.study},
            {"part", experiment.part},
            {"width_px", experiment.width_px},
            {"height_px", experiment.height_px},
            {"passes", experiment.passes},
            {"scenes", std::move(scenes)},
            {"distribution", distributions(context, experiment, runs, references)}};
}

/// The study so far; written after each experiment.
void write_results(const PaperRequest& request, const Json& paper) {
    write_json(request.folder / "paper.json", paper);
    const std::string text = paper_text(paper);
    try {
        lxs::write_file_atomically((request.folder / "paper.md").string(),
                                   std::as_bytes(std::span(text)));
    } catch (const std::runtime_error& error) {
        throw lxs::OutputFailure(error.what());
    }
}

}  // namespace

ExitCode redo_paper(const PaperRequest& request, const MethodTable& table,
                    const lxs::PluginLibrary& plugins, const lxs::Interruption& interruption,
                    lxs::ConsoleLog& log) {
    const Context context{request, table, plugins, interruption, log};
    std::vector<Experiment> experiments;
    for (const Experiment& experiment : request.experiments) {
        experiments.push_back(scaled(experiment, request.scale));
        check_cases(context, plan_experiment(experiments.back(), scenes_of(request, experiment),
                                             table, 1, 1));
    }
    Build build = this_build();
    build.accepts_others = request.any_build;
    Json paper{{"schema", kPaperSchema},
               {"created", utc_now()},
               {"revision", build.revision},
               {"machine", machine()},
               {"scale", request.scale},
               {"seeds", request.seeds},
               {"photons_per_pass", table.photons_per_pass},
               {"reference_seconds", request.reference_seconds},
               {"experiments", Json::array()}};
    ReferenceCache references(request.references);
    bool failed = false;
    for (const Experiment& experiment : experiments) {
        if (!make_missing_references(context, experiment)) return ExitCode::Interrupted;
        const ExperimentRuns done = carry_out(context, experiment, build, references);
        if (done.interrupted) return ExitCode::Interrupted;
        failed = failed || done.failed;
        paper["experiments"].push_back(
            experiment_document(context, experiment, done.runs, references));
        write_results(request, paper);
    }
    std::fputs(paper_text(paper).c_str(), stdout);
    return failed ? ExitCode::RunsFailed : ExitCode::Success;
}

}  // namespace bench
