// aips-conformance: our images against LuxRender's own, scene by scene
// (docs/measured/conformance.md).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>

#include "check_scene.h"

namespace {

using namespace conformance;
namespace fs = std::filesystem;

/// Documented in docs/measured/conformance.md.
enum ExitCode { Passes = 0, Misses = 1, BadCommand = 2, NoImages = 3 };

struct Command {
    std::string folder;
    std::vector<std::string> scenes;
    std::vector<std::string> integrators = {"path", "aips"};
    std::string markdown;
    std::string keep;
    CheckSettings settings;
};

void declare(CLI::App& app, Command& command) {
    app.add_option("--folder", command.folder,
                   "NAME.lxs and NAME.exr (default: shared/lux-conformance beside the project)")
        ->type_name("DIR");
    app.add_option("--scenes", command.scenes, "names, separated by commas (default: all)")
        ->delimiter(',');
    app.add_option("--integrators", command.integrators, "default: path,aips")->delimiter(',');
    app.add_option("--seconds", command.settings.budget.seconds,
                   "longest rendering of a scene with an integrator (default: 180)")
        ->check(CLI::PositiveNumber);
    app.add_option("--first-passes", command.settings.budget.first_passes,
                   "passes of each half in the first round (default: 32)")
        ->check(CLI::Range(1u, 1000000u));
    app.add_option("--renderer", command.settings.renderer, "default: this build's lxsrender")
        ->type_name("FILE")
        ->check(CLI::ExistingFile);
    app.add_option("--threads", command.settings.threads, "default: all processors");
    app.add_option("--markdown", command.markdown, "writes the table as Markdown, too")
        ->type_name("FILE.md");
    app.add_option("--keep", command.keep, "keeps the images as SCENE.INTEGRATOR.exr")
        ->type_name("DIR");
}

void write_markdown(const std::string& file, const std::vector<Row>& rows) {
    std::string text = table_head(TableForm::Markdown);
    for (const Row& row : rows)
        text += table_line(row, TableForm::Markdown);
    std::ofstream out(file);
    out << text << table_notes(rows);
    if (!out.flush()) throw std::runtime_error("cannot write " + file);
}

ExitCode run(Command& command) {
    if (command.folder.empty() && !fs::exists(CONFORMANCE_FOLDER)) {
        fmt::print("skipped: no LuxRender images in {}\n", CONFORMANCE_FOLDER);
        return Passes;
    }
    const fs::path folder = command.folder.empty() ? CONFORMANCE_FOLDER : command.folder;
    if (!fs::is_directory(folder)) throw std::runtime_error("no folder " + folder.string());
    const std::vector<Scene> scenes = scenes_in(folder, command.scenes);
    if (scenes.empty()) throw std::runtime_error("no scene with an image in " + folder.string());
    if (!command.keep.empty()) fs::create_directories(command.keep);
    command.settings.keep = command.keep;

    std::vector<Row> rows;
    fmt::print("{}", table_head(TableForm::Text));
    for (const Scene& scene : scenes) {
        for (const std::string& integrator : command.integrators) {
            rows.push_back(check_scene(scene, integrator, command.settings));
            fmt::print("{}", table_line(rows.back(), TableForm::Text));
            std::fflush(stdout);
        }
    }
    fmt::print("{}", table_notes(rows));
    if (!command.markdown.empty()) write_markdown(command.markdown, rows);
    const auto any = [&rows](auto&& is) { return std::any_of(rows.begin(), rows.end(), is); };
    if (any([](const Row& r) { return !r.failure.empty(); })) return NoImages;
    return any([](const Row& r) { return !r.passes_limits(); }) ? Misses : Passes;
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app("Compares lxsrender's images with LuxRender's own, scene by scene");
    Command command;
    declare(app, command);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? Passes : BadCommand;
    }
    return run(command);
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return BadCommand;
}
