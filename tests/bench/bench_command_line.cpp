// The command line of aips-bench.
#include "bench_command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "lxs/host/command_line_mistake.h"
#include "lxs/host/option_checks.h"

namespace bench {
namespace {

void add_method_table(CLI::App& app, BenchCommandLine& command) {
    app.add_option("--method-table", command.method_table,
                   "methods (default: tests/bench/methods.json of the sources)")
        ->type_name("FILE.json");
}

void add_references(CLI::App& app, BenchCommandLine& command) {
    app.add_option("--references", command.references,
                   "folder of the reference images (default: out/bench-references)")
        ->type_name("DIR");
}

void add_scene_table(CLI::App& app, BenchCommandLine& command) {
    app.add_option("--scene-table", command.scene_table,
                   "scenes' reference methods (default: tests/bench/scenes.json of the sources)")
        ->type_name("FILE.json");
}

void add_tables(CLI::App& app, BenchCommandLine& command) {
    add_references(app, command);
    add_method_table(app, command);
    add_scene_table(app, command);
    app.add_option("--scene-folder", command.scene_folder,
                   "where scenes are found by name (default: scenes of the sources)")
        ->type_name("DIR");
}

void add_rendering(CLI::App& app, BenchCommandLine& command) {
    app.add_option("--scenes", command.scenes, "names or .lxs files, separated by commas")
        ->delimiter(',')
        ->required();
    app.add_option("--threads", command.threads, "threads of a render (default: all processors)")
        ->check(CLI::Range(1u, 1024u));
    app.add_option("--width", command.width_px,
                   "width of the images in pixels (default: the scenes' own)")
        ->type_name("PIXELS")
        ->check(CLI::Range(1u, 65536u));
    add_tables(app, command);
}

void add_run(CLI::App& app, BenchCommandLine& command) {
    CLI::App& run = *app.add_subcommand("run", "render, measure and summarise a study");
    add_rendering(run, command);
    run.add_option("--methods", command.methods, "names, separated by commas")
        ->delimiter(',')
        ->required();
    run.add_option("--budgets", command.budgets_s, "seconds, separated by commas")
        ->delimiter(',')
        ->check(CLI::Validator(lxs::check_positive, "SECONDS"));
    run.add_option("--seeds", command.seeds, "number of seeds (default: 3)")
        ->check(CLI::Range(1u, 1000u));
    run.add_option("--out", command.folder, "folder of the study")->type_name("DIR")->required();
    run.add_option("--variants", command.variants, "fixed, shipped or both (default)")
        ->delimiter(',')
        ->check(CLI::IsMember({"fixed", "shipped"}));
    run.add_option("--clock", command.clock, "clock that has to pass the budgets (default: both)")
        ->check(CLI::IsMember({"both", "cpu", "wall"}));
    run.add_option("--set", command.set,
                   "override for all methods with that integrator; may be repeated")
        ->type_name("plugin.parameter=value")
        ->expected(1)
        ->take_all()
        ->check(CLI::Validator(lxs::check_override, ""));
    run.add_option("--photons-per-pass", command.photons_per_pass,
                   "photon paths in each pass of every photon method (default: the method table's)")
        ->type_name("COUNT")
        ->check(CLI::Range(1u, 4294967295u));
    run.add_option("--baseline", command.baseline, "method that ratios refer to (default: sppm)");
    run.add_flag("--photon-part", command.photon_part,
                 "photon methods keep their photons' part apart; this takes a little of their "
                 "time");
    run.callback([&command] { command.command = Command::Run; });
}

void add_reference(CLI::App& app, BenchCommandLine& command) {
    CLI::App& reference = *app.add_subcommand("reference", "add to the reference images of scenes");
    add_rendering(reference, command);
    reference.add_option("--seconds", command.seconds, "seconds for each scene (default: 60)")
        ->check(CLI::Validator(lxs::check_positive, "SECONDS"));
    reference.add_option("--clock", command.clock, "clock of --seconds: wall (default) or cpu")
        ->check(CLI::IsMember({"cpu", "wall"}));
    reference.add_flag("--up-to", command.up_to,
                       "only what is missing to that many seconds in all");
    reference.callback([&command] { command.command = Command::Reference; });
}

void add_agreement(CLI::App& app, BenchCommandLine& command) {
    CLI::App& agreement = *app.add_subcommand(
        "agreement", "test whether a study's methods agree within noise and claimed bias");
    agreement.add_option("dir", command.folder, "folder of the study")
        ->type_name("DIR")
        ->required();
    agreement
        .add_option("--smaller-radius", command.smaller_radius,
                    "study of the baseline at a smaller fixed radius, which tells the bias")
        ->type_name("DIR");
    add_references(agreement, command);
    add_scene_table(agreement, command);
    agreement.callback([&command] { command.command = Command::Agreement; });
}

void add_report(CLI::App& app, BenchCommandLine& command) {
    CLI::App& report =
        *app.add_subcommand("report", "write a study as one HTML page that opens offline");
    report.add_option("dir", command.folder, "folder of the study")->type_name("DIR")->required();
    report.add_option("--out", command.report_file, "the page (default: DIR/report.html)")
        ->type_name("FILE.html");
    add_references(report, command);
    report
        .add_option("--page", command.report_page,
                    "page without data (default: what the target bench-report-assets built)")
        ->type_name("FILE.html");
    report.callback([&command] { command.command = Command::Report; });
}

void add_paper(CLI::App& app, BenchCommandLine& command) {
    CLI::App& paper = *app.add_subcommand("paper", "redo the figures of Liu and Zheng 2014");
    paper.add_option("--out", command.folder, "folder of the study")->type_name("DIR")->required();
    paper
        .add_option("--figures", command.figures,
                    "6-7, 8, 9a, 9b, 9c, 9d, 10, separated by commas (default: all)")
        ->delimiter(',');
    paper
        .add_option("--scale", command.scale,
                    "scales widths, passes and seconds, above 0 to 1 (default: 1)")
        ->check(CLI::Validator(lxs::check_positive, "SCALE"))
        ->check(CLI::Range(0.0, 1.0));
    paper.add_option("--seeds", command.seeds, "number of seeds (default: 3)")
        ->check(CLI::Range(1u, 1000u));
    paper.add_option("--threads", command.threads, "threads of a render (default: all processors)")
        ->check(CLI::Range(1u, 1024u));
    paper
        .add_option("--reference-seconds", command.seconds,
                    "wall seconds that a scene's references have at least (default: 60)")
        ->check(CLI::Validator(lxs::check_positive, "SECONDS"));
    paper.add_flag("--any-build", command.any_build,
                   "runs that another build rendered count as done: for new tables of old runs");
    paper
        .add_option("--paper-table", command.paper_table,
                    "experiments (default: tests/bench/paper/paper.json of the sources)")
        ->type_name("FILE.json");
    add_tables(paper, command);
    paper.callback([&command] { command.command = Command::Paper; });
}

void add_table(CLI::App& app, BenchCommandLine& command) {
    CLI::App& table = *app.add_subcommand(
        "table", "print a study's comparisons, or errors of several studies, as Markdown");
    table
        .add_option("dir", command.shown,
                    "folder of the study; with --error several, and NAME=DIR for a column's name")
        ->type_name("DIR")
        ->required();
    table.add_option("--clock", command.clock, "cpu (default) or wall")
        ->check(CLI::IsMember({"cpu", "wall"}));
    CLI::Option* const error =
        table
            .add_option(
                "--error", command.shown_error,
                "one table of this error, a row each scene: relmse_rest, relmse, mse or rmse")
            ->check(CLI::IsMember({"relmse_rest", "relmse", "mse", "rmse"}));
    table
        .add_option("--budget", command.shown_budget_s,
                    "of --error: seconds (default: the first study's longest budget)")
        ->needs(error)
        ->check(CLI::Validator(lxs::check_positive, "SECONDS"));
    table.callback([&command] {
        if (command.shown_error.empty() && command.shown.size() > 1)
            throw CLI::ValidationError("dir", "several are shown with --error only");
        command.command = Command::Table;
    });
}

void add_others(CLI::App& app, BenchCommandLine& command) {
    add_table(app, command);
    CLI::App& methods = *app.add_subcommand("methods", "print the methods that this build can run");
    add_method_table(methods, command);
    methods.callback([&command] { command.command = Command::Methods; });
    // What `run` and `reference` start for each render; nothing for users.
    CLI::App& one = *app.add_subcommand("render-one", "")->group("");
    one.add_option("job", command.folder)->required();
    one.callback([&command] { command.command = Command::RenderOne; });
}

void check_repetition(const std::vector<std::string>& names, const char* option) {
    for (auto name = names.begin(); name != names.end(); ++name) {
        if (std::find(names.begin(), name, *name) != name) {
            throw CLI::ValidationError(option, fmt::format("\"{}\" is given twice", *name));
        }
    }
}

}  // namespace

std::optional<ExitCode> parse_command_line(int argc, const char* const* argv,
                                           BenchCommandLine& command) {
    CLI::App app("Measures rendering methods: run time against error (docs/measured/method.md).",
                 "aips-bench");
    app.require_subcommand(1);
    app.footer(lxs::exit_code_help(kExitCodes));
    app.failure_message(&lxs::mistake_message);
    add_run(app, command);
    add_reference(app, command);
    add_agreement(app, command);
    add_report(app, command);
    add_paper(app, command);
    add_others(app, command);
    try {
        app.parse(argc, argv);
        check_repetition(command.scenes, "--scenes");
        check_repetition(command.methods, "--methods");
        check_repetition(command.variants, "--variants");
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? ExitCode::Success : ExitCode::Usage;
    }
    std::sort(command.budgets_s.begin(), command.budgets_s.end());
    return std::nullopt;
}

}  // namespace bench
