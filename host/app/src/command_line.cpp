// The command line of lxsrender.
#include "lxs/host/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "lxs/host/budget.h"
#include "lxs/host/command_line_mistake.h"
#include "lxs/host/display_server.h"
#include "lxs/host/frame_number.h"
#include "lxs/host/help_layout.h"
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

/// Puts the share that it is in place of a value in per cent.
std::string read_target_error(std::string& text) {
    std::string number = text;
    const bool percent = number.ends_with('%');
    if (percent) number.pop_back();
    double value = 0;
    const bool read = CLI::detail::lexical_cast(number, value) && std::isfinite(value);
    const double share = percent ? value / 100 : value;
    if (!read || !(share > 0 && share <= 1)) {
        std::string wrong =
            "expected an error above 0 and at most 1, as 0.05, or in per cent, as 5%; found " +
            in_quotes(text);
        if (read && !percent && value > 1 && value <= 100)
            wrong += fmt::format("; did you mean {}%?", number);
        return wrong;
    }
    text = fmt::format("{}", share);
    return "";
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

/// Whole numbers of these alone.
CLI::Validator within(unsigned least, unsigned most) {
    return CLI::Range(least, most).description("");
}

/// Values that stand for others until all options have been read.
struct Switches {
    bool seed_per_frame = false, no_error_estimate = false, no_advice = false;
    bool quiet = false, verbose = false;
};

/// How long, by what, at which size.
void add_render_options(CLI::App& app, CommandLine& command, Switches& switches) {
    const std::string length =
        fmt::format("When to stop (default: as the scene says, or {} passes)", kDefaultPasses);
    auto* passes = app.add_option("--passes", command.passes,
                                  "Passes to render; for path these are samples per pixel.")
                       ->group(length)
                       ->type_name("COUNT")
                       ->check(CLI::Validator(check_positive, ""));
    app.add_option("--time", command.seconds,
                   "Seconds to render, checked between passes; not together with --passes.")
        ->group(length)
        ->type_name("SECONDS")
        ->check(CLI::Validator(check_positive, ""))
        ->excludes(passes);
    auto* target = app.add_option("--target-error", command.target_error,
                                  "Estimated error to end at, the square root of relMSE: 0.05, "
                                  "or 5%. Beside --passes or --time, whichever is first.")
                       ->group(length)
                       ->type_name("ERROR")
                       ->transform(CLI::Validator(read_target_error, ""));
    app.add_flag("--no-error-estimate", switches.no_error_estimate,
                 "Estimate no errors: none in progress, statistics and image file.")
        ->group(length)
        ->excludes(target);

    const char* const how = "How to render";
    app.add_option("--integrator", command.integrator,
                   "Surface integrator, instead of the scene's; --list-plugins names them.")
        ->group(how)
        ->type_name("NAME");
    app.add_option("--sampler", command.sampler, "Sampler, instead of the scene's.")
        ->group(how)
        ->type_name("NAME");
    app.add_option("--set", command.overrides,
                   "A parameter of the integrator or the sampler, as aips.guide=none; may be "
                   "repeated. --describe aips lists them.")
        ->group(how)
        ->type_name("PLUGIN.PARAMETER=VALUE")
        ->expected(1)
        ->allow_extra_args(false)  // one value each: what follows is another argument
        ->take_all()
        ->check(CLI::Validator(check_override, ""));
    app.add_option("--seed", command.seed,
                   "Seed of all random numbers, instead of the integrator's (default: 0).")
        ->group(how)
        ->type_name("NUMBER");
    app.add_option("--threads", command.threads,
                   "Number of threads, 1 to 1024 (default: all processors). The image is the same "
                   "for any number.")
        ->group(how)
        ->type_name("COUNT")
        ->check(within(1, 1024));
    app.add_option("--width", command.width,
                   "Width of the image, 1 to 65536 pixels, instead of the scene's; the height "
                   "follows.")
        ->group(how)
        ->type_name("PIXELS")
        ->check(within(1, 65536));
    app.add_option("--height", command.height,
                   "Height of the image, 1 to 65536 pixels, instead of the scene's or of what "
                   "follows --width.")
        ->group(how)
        ->type_name("PIXELS")
        ->check(within(1, 65536));
    app.add_flag("--strict", command.strict,
                 "What LuxRender would only warn of is an error: unknown names and parameters, "
                 "missing files.")
        ->group(how);
}

void add_output_options(CLI::App& app, CommandLine& command) {
    const char* const files = "What to write";
    app.add_option("-o,--output", command.output,
                   "Image to write: of FILE.exr the EXR and a PNG beside it, of FILE.png the PNG "
                   "alone (default: an EXR and a PNG with the film's file name, in the current "
                   "folder).")
        ->group(files)
        ->type_name("FILE")
        ->check(CLI::Validator(check_image_name, ""));
    app.add_option("--layers", command.layers,
                   fmt::format("Layers that the EXR has beside the image, instead of the scene's; "
                               "separated by commas, of {}.",
                               fmt::join(layer_names(), ", ")))
        ->group(files)
        ->type_name("NAMES")
        ->check(CLI::Validator(check_layers, ""));
    app.add_flag("--denoise", command.denoise,
                 "Denoise the PNG, and write the layer \"denoised\" into the EXR, whose image "
                 "stays as it is. --denoise=last: at the end alone, not in the images so far.")
        ->group(files)
        ->transform(CLI::Validator(read_denoising, ""));
    app.add_option("--exposure", command.exposure_stops,
                   "Stops by which the PNG is brighter (2 to this power), or darker below 0, -64 "
                   "to 64; the EXR stays as it is.")
        ->group(files)
        ->type_name("STOPS")
        ->check(CLI::Validator(check_stops, ""));
    app.add_option("--write-every", command.write_every,
                   "Seconds after which the image so far is written anew, first after the first "
                   "pass; 0: at the end alone (default: the film's writeinterval, for the PNG its "
                   "displayinterval; less often where writing would take 2 % of the time).")
        ->group(files)
        ->type_name("SECONDS")
        ->check(CLI::Validator(check_not_negative, ""));
    app.add_option("--stats", command.statistics,
                   "JSON file to write, with settings, times and counts.")
        ->group(files)
        ->type_name("FILE.json");
}

void add_watching_options(CLI::App& app, CommandLine& command, Switches& switches) {
    const char* const watching = "What to show and say";
    app.add_option("--serve", command.serve,
                   "Serve a page for browsers of this machine that shows the image as it converges "
                   "and lets the render pause or end. PORT: any that is free, unless given.")
        ->group(watching)
        ->type_name("[PORT]")
        ->check(CLI::Validator(check_page, ""));
    app.add_option("--display-server", command.display_server,
                   "Viewer tev to show the image so far in, about every second and at the end; its "
                   "port is 14158 unless given.")
        ->group(watching)
        ->type_name("HOST[:PORT]")
        ->check(CLI::Validator(check_viewer, ""));
    auto* explain = app.add_flag("--explain", command.explain,
                                 "Say at the end what became of the light of each lamp and of the "
                                 "photons that met each material, what was left out, where time "
                                 "went.")
                        ->group(watching);
    app.add_flag("--no-advice", switches.no_advice,
                 "Look for nothing that is wrong with the render, and count nothing by light and "
                 "material.")
        ->group(watching)
        ->excludes(explain);
    auto* quiet =
        app.add_flag("--quiet", switches.quiet, "Print warnings and errors only.")->group(watching);
    app.add_flag("--verbose", switches.verbose, "Print more.")->group(watching)->excludes(quiet);
}

void add_checkpoint_options(CLI::App& app, CommandLine& command) {
    const char* const pauses = "Renders that can be killed";
    auto* checkpoint = app.add_option("--checkpoint", command.checkpoint,
                                      "File to save the state of the render in, now and then and "
                                      "at its end.")
                           ->group(pauses)
                           ->type_name("FILE");
    app.add_option("--checkpoint-interval", command.checkpoint_interval,
                   "Least seconds from one checkpoint to the next, 0: after every pass "
                   "(default: 300).")
        ->group(pauses)
        ->type_name("SECONDS")
        ->check(CLI::Validator(check_not_negative, ""))
        ->needs(checkpoint);
    app.add_flag("--resume", command.resume,
                 "Go on from the checkpoint, if there is one: the image is the same as without a "
                 "break; --passes and --time count from the very beginning.")
        ->group(pauses)
        ->needs(checkpoint);
}

void add_animation_options(CLI::App& app, CommandLine& command, Switches& switches) {
    const char* const frames = "Frames of an animation";
    app.add_option("--learned-out", command.learned_out,
                   "File for what the render learns: guide, choices of lights, plan of photons; "
                   "written at its end, for the next frame.")
        ->group(frames)
        ->type_name("FILE");
    app.add_option("--learned-in", command.learned_in,
                   "Begin with what another render learned, of this scene or one that is much like "
                   "it; it fades, and the image's expectation is the same.")
        ->group(frames)
        ->type_name("FILE");
    app.add_flag("--seed-per-frame", switches.seed_per_frame,
                 "Noise of its own for each frame: adds 2^32 times the number in the scene's file "
                 "name (7 in frame_0007.lxs) to the seed.")
        ->group(frames);
}

void add_plugin_options(CLI::App& app, CommandLine& command) {
    const char* const plugins = "What there is";
    auto* list = app.add_flag("--list-plugins", command.list_plugins, "List the integrators.")
                     ->group(plugins);
    auto* describe = app.add_option("--describe", command.describe,
                                    "List the parameters of an integrator, or of any material, "
                                    "texture, shape, light, film and so on; of a kind of statement "
                                    "(Material), its names.")
                         ->group(plugins)
                         ->type_name("NAME")
                         ->excludes(list);
    app.add_flag("--markdown", command.markdown, "--describe as a Markdown table.")
        ->group(plugins)
        ->needs(describe);
    app.add_flag("--scene-language", command.scene_language,
                 "Print the reference of the scene language as Markdown.")
        ->group(plugins)
        ->excludes(list)
        ->excludes(describe);
    app.add_option("--plugin-path", command.plugin_paths,
                   "Folder with plugin modules, before the installed ones; may be repeated.")
        ->group(plugins)
        ->type_name("DIR")
        ->expected(1)
        ->allow_extra_args(false)
        ->take_all();
}

constexpr const char* kExamples =
    "Examples:\n"
    "  lxsrender scene.lxs --integrator aips --time 60\n"
    "  lxsrender scene.lxs --passes 64 -o image.exr --denoise --stats image.json\n"
    "  lxsrender scene.lxs --target-error 5% --serve\n"
    "  lxsrender --describe matte\n\n";

}  // namespace

std::string version() {
    return LXS_VERSION;
}

std::optional<ExitCode> parse_command_line(int argc, const char* const* argv,
                                           CommandLine& command) {
    CLI::App app("Renders a scene file of LuxRender (.lxs) or pbrt (.pbrt) to OpenEXR and PNG.",
                 "lxsrender");
    app.formatter(std::make_shared<HelpLayout>());
    app.failure_message(&mistake_message);
    app.footer(kExamples + exit_code_help(kExitCodes));
    app.add_option("scene", command.scene, "Scene file; - reads standard input.")
        ->type_name("SCENE.lxs");
    Switches switches;
    add_render_options(app, command, switches);
    add_output_options(app, command);
    add_watching_options(app, command, switches);
    add_checkpoint_options(app, command);
    add_mpi_options(app, command);
    add_animation_options(app, command, switches);
    add_plugin_options(app, command);
    app.set_help_flag("-h,--help", "Print this.")->group("What there is");
    app.set_version_flag("--version", version(), "Print the version.")->group("What there is");
    try {
        app.parse(arguments_from(argc, argv));
        if (command.scene.empty() && !command.list_plugins && !command.describe &&
            !command.scene_language) {
            throw CLI::RequiredError("SCENE.lxs");
        }
        check_mpi(command);
        if (switches.seed_per_frame) command.frame = frame_of(command.scene);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? ExitCode::Success : ExitCode::Usage;
    }
    command.error_estimate = !switches.no_error_estimate;
    command.advice = !switches.no_advice && !command.mpi;  // each rank would do all of its work
    if (switches.quiet) command.verbosity = Verbosity::Quiet;
    if (switches.verbose) command.verbosity = Verbosity::Verbose;
    return std::nullopt;
}

}  // namespace lxs
