// The command line of lxsrender.
#include "lxs/host/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <string_view>

#include "lxs/host/command_line_mistake.h"
#include "lxs/host/display_server.h"
#include "lxs/host/frame_number.h"
#include "lxs/host/option_checks.h"
#include "lxs/host/output_files.h"
#include "lxs/imaging/layer_names.h"
#include "lxs/sdk/diagnostics.h"
#include "lxs/serve/live_server.h"
#include "lxs/serve/page.h"
#include "mpi_options.h"

namespace lxs {
namespace {

std::string check_image_name(const std::string& name) {
    const bool known = has_suffix(name, ".exr") || has_suffix(name, ".png");
    return known ? "" : "the name must end in .exr or .png: " + name;
}

std::string check_stops(const std::string& text) {
    return check_within(text, 64);  // beyond it any image is black or white
}

/// What `read` says of a text that it does not take.
template <class Read>
std::string mistake_in(const std::string& text, const Read& read) {
    try {
        (void)read(text);
        return "";
    } catch (const std::invalid_argument& mistake) {
        return mistake.what();
    }
}

std::string check_viewer(const std::string& text) {
    return mistake_in(text, &ViewerAddress::parse);
}

std::string check_layers(const std::string& text) {
    return mistake_in(
        text, [](const std::string& names) { return layers_named(split_layer_names(names)); });
}

/// Puts the number of its meaning in place of the value of --denoise, which is "true" where none is
/// given.
std::string read_denoising(std::string& text) {
    if (text != "true" && text != "last") return "expected last, found " + in_quotes(text);
    text = std::to_string(static_cast<int>(text == "last" ? Denoising::Last : Denoising::All));
    return "";
}

std::string check_page(const std::string& text) {
    std::uint16_t port = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, port);
    if (error != std::errc() || rest != end)
        return "expected a port from 0 to 65535, found " + in_quotes(text);
    if (!serve::browsers_open(port)) {
        return fmt::format(
            "browsers open no page at port {}, which belongs to another service; give another port",
            port);
    }
    if (!serve::page_text().empty()) return "";
    return "this lxsrender has no page: build it where npm is installed, with -DAIPS_SERVE=ON";
}

bool is_number(std::string_view text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The arguments, last first, as CLI11 takes them. What follows --serve is its port only if it is a
/// number: else the scene.
std::vector<std::string> arguments_from(int argc, const char* const* argv) {
    std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const bool has_port = i + 1 < arguments.size() && is_number(arguments[i + 1]);
        if (arguments[i] == "--serve" && !has_port) arguments[i] = "--serve=0";
    }
    std::reverse(arguments.begin(), arguments.end());
    return arguments;
}

std::uint32_t frame_of(const std::string& scene) {
    if (const auto frame = frame_number(scene)) return *frame;
    throw CLI::ValidationError("--seed-per-frame",
                               "the name of the scene's file must have a "
                               "number of at most nine digits, as frame_0007.lxs has: " +
                                   scene);
}

void add_output_options(CLI::App& app, CommandLine& command) {
    app.add_option("-o,--output", command.output,
                   "image to write: of FILE.exr the EXR and a PNG beside it, of FILE.png the PNG "
                   "alone (default: an EXR and a PNG with the film's file name, in the current "
                   "folder)")
        ->check(CLI::Validator(check_image_name, "FILE"));
    app.add_option("--layers", command.layers,
                   fmt::format("layers that the EXR has beside the image, instead of the scene's; "
                               "separated by commas, of {}",
                               fmt::join(layer_names(), ", ")))
        ->type_name("NAMES")
        ->check(CLI::Validator(check_layers, ""));
    app.add_option("--exposure", command.exposure_stops,
                   "stops by which the PNG is brighter (2 to this power), or darker below 0; the "
                   "EXR stays as it is")
        ->type_name("STOPS")
        ->check(CLI::Validator(check_stops, ""));
    app.add_flag("--denoise", command.denoise,
                 "denoise the PNG, and write the layer \"denoised\" into the EXR, whose image "
                 "stays as it is; --denoise=last: at the end alone, not in the images so far")
        ->transform(CLI::Validator(read_denoising, ""));
    app.add_option("--write-every", command.write_every,
                   "seconds after which the image so far is written anew, first after the first "
                   "pass; 0: at the end alone (default: the film's writeinterval, for the PNG its "
                   "displayinterval; less often where writing would take 2 % of the time)")
        ->type_name("SECONDS")
        ->check(CLI::Validator(check_not_negative, ""));
    app.add_option("--display-server", command.display_server,
                   "viewer tev to show the image so far in, about every second and at the end; its "
                   "port is 14158 unless given")
        ->type_name("HOST[:PORT]")
        ->check(CLI::Validator(check_viewer, ""));
    app.add_option("--serve", command.serve,
                   "serve a page for browsers of this machine that shows the image as it converges "
                   "and lets the render pause or end; PORT: any that is free, unless given")
        ->type_name("[PORT]")
        ->check(CLI::Validator(check_page, ""));
    app.add_option("--stats", command.statistics, "JSON file to write with settings, times, counts")
        ->type_name("FILE.json");
    auto* explain = app.add_flag("--explain", command.explain,
                                 "say at the end what became of the light of each lamp and of the "
                                 "photons that met each material, what was left out, where time "
                                 "went");
    app.add_flag("!--no-advice", command.advice,
                 "look for nothing that is wrong with the render, and keep no account of it")
        ->excludes(explain);
}

void add_render_options(CLI::App& app, CommandLine& command) {
    app.add_option("--threads", command.threads, "number of threads (default: all processors)")
        ->check(CLI::Range(1u, 1024u));
    auto* passes = app.add_option("--passes", command.passes,
                                  "passes to render (path: samples per pixel); overrides the "
                                  "scene's haltspp, halttime and haltthreshold")
                       ->check(CLI::Validator(check_positive, "COUNT"));
    app.add_option("--time", command.seconds,
                   "seconds to render, checked between passes; overrides haltspp, halttime and "
                   "haltthreshold")
        ->check(CLI::Validator(check_positive, "SECONDS"))
        ->excludes(passes);
    auto* target = app.add_option("--target-error", command.target_error,
                                  "estimated error to end at, the square root of relMSE: 0.05 is "
                                  "5 % of a pixel; beside --passes or --time, whichever is first; "
                                  "overrides haltspp, halttime and haltthreshold")
                       ->check(CLI::Validator(check_positive, "ERROR"));
    app.add_flag("!--no-error-estimate", command.error_estimate,
                 "estimate no errors: none in progress, statistics and image file")
        ->excludes(target);
    app.add_option("--seed", command.seed, "seed of all random numbers (default: 0)");
    app.add_option("--integrator", command.integrator,
                   "surface integrator, instead of the scene's choice")
        ->type_name("NAME");
    app.add_option("--set", command.overrides,
                   "give a parameter of an integrator or sampler; may be repeated")
        ->type_name("plugin.parameter=value")
        ->expected(1)
        ->allow_extra_args(false)  // one value each: what follows is another argument
        ->take_all()
        ->check(CLI::Validator(check_override, ""));
    app.add_option("--width", command.width,
                   "width of the image in pixels, instead of the scene's; the height follows")
        ->type_name("PIXELS")
        ->check(CLI::Range(1u, 65536u));
    app.add_option("--height", command.height,
                   "height of the image in pixels, instead of the scene's or what follows --width")
        ->type_name("PIXELS")
        ->check(CLI::Range(1u, 65536u));
    app.add_option("--sampler", command.sampler, "sampler, instead of the scene's choice")
        ->type_name("NAME");
    app.add_flag("--strict", command.strict,
                 "what LuxRender would only warn of is an error: unknown names and parameters, "
                 "missing files");
}

void add_checkpoint_options(CLI::App& app, CommandLine& command) {
    auto* checkpoint = app.add_option("--checkpoint", command.checkpoint,
                                      "file to save the state of the render in, now and then and "
                                      "at its end")
                           ->type_name("FILE");
    app.add_option("--checkpoint-interval", command.checkpoint_interval,
                   "least seconds from one checkpoint to the next, 0: after every pass "
                   "(default: 300)")
        ->check(CLI::Validator(check_not_negative, ""))
        ->needs(checkpoint);
    app.add_flag("--resume", command.resume,
                 "go on from the checkpoint, if there is one: the image is the same as without a "
                 "break; --passes and --time count from the very beginning")
        ->needs(checkpoint);
}

void add_animation_options(CLI::App& app, CommandLine& command, bool& seed_per_frame) {
    app.add_option("--learned-out", command.learned_out,
                   "file for what the render learns: guide, choices of lights, plan of photons; "
                   "written at its end, for the next frame of an animation")
        ->type_name("FILE");
    app.add_option("--learned-in", command.learned_in,
                   "begin with what another render learned, of this scene or one that is much like "
                   "it; it fades, and the image's expectation is the same")
        ->type_name("FILE");
    app.add_flag("--seed-per-frame", seed_per_frame,
                 "noise of its own for each frame: adds 2^32 times the number in the scene's file "
                 "name (7 in frame_0007.lxs) to the seed");
}

void add_plugin_options(CLI::App& app, CommandLine& command) {
    app.add_option("--plugin-path", command.plugin_paths,
                   "folder with plugin modules, before the installed ones; may be repeated")
        ->type_name("DIR")
        ->expected(1)
        ->allow_extra_args(false)
        ->take_all();
    auto* list = app.add_flag("--list-plugins", command.list_plugins, "list the integrators");
    auto* describe = app.add_option("--describe", command.describe, "list a plugin's parameters")
                         ->type_name("NAME")
                         ->excludes(list);
    app.add_flag("--scene-language", command.scene_language,
                 "print the reference of the scene language as Markdown")
        ->excludes(list)
        ->excludes(describe);
    app.add_flag("--markdown", command.markdown, "--describe as a Markdown table")->needs(describe);
}

}  // namespace

std::string version() {
    return LXS_VERSION;
}

std::optional<ExitCode> parse_command_line(int argc, const char* const* argv,
                                           CommandLine& command) {
    CLI::App app("Renders a LuxRender scene file (.lxs) to OpenEXR and PNG.", "lxsrender");
    app.set_version_flag("--version", version());
    app.failure_message(&mistake_message);
    app.footer(exit_code_help(kExitCodes));
    app.add_option("scene", command.scene, "scene file, - for standard input")
        ->type_name("SCENE.lxs");
    add_output_options(app, command);
    add_render_options(app, command);
    add_checkpoint_options(app, command);
    add_mpi_options(app, command);
    bool seed_per_frame = false;
    add_animation_options(app, command, seed_per_frame);
    add_plugin_options(app, command);
    bool quiet = false;
    bool verbose = false;
    auto* quiet_flag = app.add_flag("--quiet", quiet, "print warnings and errors only");
    app.add_flag("--verbose", verbose, "print more")->excludes(quiet_flag);
    try {
        app.parse(arguments_from(argc, argv));
        if (command.scene.empty() && !command.list_plugins && !command.describe &&
            !command.scene_language) {
            throw CLI::RequiredError("SCENE.lxs");
        }
        check_mpi(command);
        if (seed_per_frame) command.frame = frame_of(command.scene);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? ExitCode::Success : ExitCode::Usage;
    }
    if (command.mpi) command.advice = false;  // each rank would have to do all of the work
    if (quiet) command.verbosity = Verbosity::Quiet;
    if (verbose) command.verbosity = Verbosity::Verbose;
    return std::nullopt;
}

}  // namespace lxs
