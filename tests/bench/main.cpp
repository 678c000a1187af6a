// aips-bench: run time against error.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <fstream>

#include "agreement_command.h"
#include "bench_command_line.h"
#include "comparison_table.h"
#include "error_table.h"
#include "lxs/host/failure.h"
#include "measured_render.h"
#include "method_check.h"
#include "paper_command.h"
#include "reference_command.h"
#include "report_command.h"
#include "run_command.h"
#include "study_summary.h"

namespace {

using namespace bench;

std::filesystem::path or_default(const std::string& given, const char* fallback) {
    return given.empty() ? fallback : given;
}

std::vector<BenchScene> find_scenes(const BenchCommandLine& command) {
    std::vector<BenchScene> scenes;
    for (const std::string& name : command.scenes) {
        scenes.push_back(find_scene(name, or_default(command.scene_table, BENCH_SCENE_TABLE),
                                    or_default(command.scene_folder, BENCH_SCENES)));
    }
    return scenes;
}

ExitCode run(const BenchCommandLine& command, const lxs::PluginLibrary& plugins,
             lxs::ConsoleLog& log) {
    RunRequest request;
    request.study = {find_scenes(command), command.methods, command.variants, command.seeds,
                     command.budgets_s,    command.threads, command.width_px, command.clock,
                     command.set,          command.baseline};
    request.photon_part = command.photon_part;
    request.folder = command.folder;
    request.references = command.references;
    auto table = read_method_table(or_default(command.method_table, BENCH_METHOD_TABLE));
    table.photons_per_pass = command.photons_per_pass.value_or(table.photons_per_pass);
    const lxs::Interruption interruption;
    return run_study(request, table, plugins, interruption, log);
}

ExitCode reference(const BenchCommandLine& command, const lxs::PluginLibrary& plugins,
                   lxs::ConsoleLog& log) {
    ReferenceRequest request;
    request.scenes = find_scenes(command);
    request.seconds = command.seconds;
    request.clock = command.clock == "cpu" ? "cpu" : "wall";
    request.up_to = command.up_to;
    request.threads = command.threads;
    request.width_px = command.width_px;
    request.root = command.references;
    const auto table = read_method_table(or_default(command.method_table, BENCH_METHOD_TABLE));
    const lxs::Interruption interruption;
    return make_references(request, table, plugins, interruption, log);
}

Json read_summary(const std::filesystem::path& folder) {
    return read_json(folder / "summary.json", kSummarySchema);
}

ExitCode print_table(const BenchCommandLine& command) {
    const std::string clock = command.clock == "wall" ? "wall" : "cpu";
    if (command.shown_error.empty()) {
        const Json summary = read_summary(command.shown.front());
        std::fputs(comparison_table(summary, clock).c_str(), stdout);
        return ExitCode::Success;
    }
    std::vector<ShownStudy> studies;
    for (const std::string& shown : command.shown) {
        const std::size_t folder = shown.find('=') + 1;  // 0 without a name
        studies.push_back(
            {read_summary(shown.substr(folder)), folder > 0 ? shown.substr(0, folder - 1) : ""});
    }
    const ShownError error{command.shown_error, clock, command.shown_budget_s};
    std::fputs(error_table(studies, error).c_str(), stdout);
    return ExitCode::Success;
}

ExitCode agreement(const BenchCommandLine& command, lxs::ConsoleLog& log) {
    return test_agreement({command.folder, command.references, command.smaller_radius,
                           or_default(command.scene_table, BENCH_SCENE_TABLE)},
                          log);
}

ExitCode report(const BenchCommandLine& command, lxs::ConsoleLog& log) {
    const std::filesystem::path study = command.folder;
    const ReportRequest request{
        study, command.references, or_default(command.report_page, BENCH_REPORT_PAGE),
        command.report_file.empty() ? study / "report.html"
                                    : std::filesystem::path(command.report_file)};
    write_report(request);
    log.info(fmt::format("report: {}", request.output.string()));
    return ExitCode::Success;
}

ExitCode paper(const BenchCommandLine& command, const lxs::PluginLibrary& plugins,
               lxs::ConsoleLog& log) {
    const PaperTable experiments =
        read_paper_table(or_default(command.paper_table, BENCH_PAPER_TABLE));
    PaperRequest request;
    request.experiments = choose_experiments(experiments, command.figures);
    request.scale = command.scale;
    request.seeds = command.seeds;
    request.threads = command.threads;
    request.reference_seconds = command.seconds;
    request.any_build = command.any_build;
    request.folder = command.folder;
    request.references = command.references;
    request.scene_table = or_default(command.scene_table, BENCH_SCENE_TABLE);
    request.scene_folder = or_default(command.scene_folder, BENCH_SCENES);
    auto table = read_method_table(or_default(command.method_table, BENCH_METHOD_TABLE));
    table.photons_per_pass = experiments.photons_per_pass;
    const lxs::Interruption interruption;
    return redo_paper(request, table, plugins, interruption, log);
}

ExitCode render_one(const BenchCommandLine& command, lxs::ConsoleLog& log) {
    const RenderJob job = render_job_from(read_json(command.folder));
    write_json(job.result, measured_render(job, log));
    return ExitCode::Success;
}

/// Names on standard output; why the others are left out on standard error.
ExitCode print_methods(const BenchCommandLine& command, const lxs::PluginLibrary& plugins,
                       lxs::ConsoleLog& log) {
    const auto table = read_method_table(or_default(command.method_table, BENCH_METHOD_TABLE));
    for (const Method& method : table.methods) {
        try {
            check_method(method, overrides(table, method, kFixed, {}), plugins,
                         std::filesystem::temp_directory_path(), log);
            std::puts(method.name.c_str());
        } catch (const StudyError& error) {
            log.info(error.what());
        }
    }
    return ExitCode::Success;
}

ExitCode carry_out(const BenchCommandLine& command, lxs::PluginLibrary& plugins,
                   lxs::ConsoleLog& log) {
    if (command.command == Command::Table) return print_table(command);
    if (command.command == Command::Agreement) return agreement(command, log);
    if (command.command == Command::Report) return report(command, log);
    if (command.command == Command::RenderOne) return render_one(command, log);
    plugins.load_folder(lxs::own_plugin_folder());
    if (command.command == Command::Methods) return print_methods(command, plugins, log);
    if (command.command == Command::Paper) return paper(command, plugins, log);
    return command.command == Command::Run ? run(command, plugins, log)
                                           : reference(command, plugins, log);
}

}  // namespace

int main(int argc, char** argv) {
    BenchCommandLine command;
    if (const auto done = parse_command_line(argc, argv, command)) return static_cast<int>(*done);
    // A single render's log goes to a file of the study: it is to hold the engine's own words.
    const bool to_file = command.command == Command::RenderOne;
    lxs::ConsoleLog log(to_file ? lxs::Verbosity::Verbose : lxs::Verbosity::Normal);
    // Outlives the handlers below: an exception that a module threw may need the module's code.
    lxs::PluginLibrary plugins;
    ExitCode code = ExitCode::InternalError;
    try {
        code = carry_out(command, plugins, log);
    } catch (const lxs::InputError& error) {
        log.verbatim(error.what());
        code = ExitCode::BadInput;
    } catch (const StudyError& error) {
        log.error(error.what());
        code = ExitCode::BadInput;
    } catch (const lxs::SceneFailure& error) {
        log.error(error.what());
        code = ExitCode::BadInput;
    } catch (const lxs::PluginFailure& error) {
        log.error(error.what());
        code = ExitCode::PluginFailure;
    } catch (const lxs::OutputFailure& error) {
        log.error(error.what());
        code = ExitCode::OutputFailure;
    } catch (const std::exception& error) {
        log.error(fmt::format("internal error: {}", error.what()));
    }
    return static_cast<int>(code);
}
