// A scene made ready to render: read, checked, built.
#include "lxs/host/render_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <span>
#include <system_error>
#include <vector>

#include "lxs/host/failure.h"
#include "lxs/host/seconds_since.h"
#include "lxs/host/statement_override.h"
#include "lxs/host/written_files.h"
#include "lxs/language/asset_finder.h"
#include "lxs/language/read_scene.h"
#include "lxs/pbrt/read_pbrt.h"

namespace lxs {
namespace {

/// Adds the time between construction and destruction to a phase.
class PhaseTimer {
  public:
    PhaseTimer(PhaseTimes& times, const char* phase)
        : seconds_(times[phase]), start_(std::chrono::steady_clock::now()) {}
    ~PhaseTimer() { seconds_ += seconds_since(start_); }
    PhaseTimer(const PhaseTimer&) = delete;
    PhaseTimer& operator=(const PhaseTimer&) = delete;

  private:
    double& seconds_;
    std::chrono::steady_clock::time_point start_;
};

SceneContents load(const std::string& path, Diagnostics& diagnostics, ReadFiles& files) {
    Registry registry;
    register_shapes(registry);
    register_shading(registry);
    try {
        return is_pbrt_file(path) ? read_pbrt(path, registry, diagnostics, &files)
                                  : read_scene(path, registry, diagnostics, &files);
    } catch (const std::system_error& error) {
        throw SceneFailure(error.what());
    }
}

/// The command line's seed, else the integrator's parameter "seed", else 0; and the parts of the
/// frame and of a process.
std::uint64_t choose_seed(const CommandLine& command, const ParameterReader& parameters) {
    const std::uint64_t added =
        (std::uint64_t{command.frame.value_or(0)} << 32) + command.seeds_above;
    if (command.seed) return *command.seed + added;
    const auto given =
        parameters.given("seed") ? static_cast<std::uint64_t>(parameters.integer("seed", 0)) : 0;
    return given + added;
}

/// What an integrator says of parameters that are not LuxRender's: nothing to fall back to.
class FirmDiagnostics final : public Diagnostics {
  public:
    explicit FirmDiagnostics(Diagnostics& next) : next_(next) {}
    void warning(const SourceLocation& where, const std::string& message) override {
        next_.warning(where, message);
    }
    void unknown_parameter(const SourceLocation& where, const std::string& message) override {
        next_.unknown_parameter(where, message);
    }
    void fallback(const SourceLocation& where, const std::string& message,
                  const std::string& /*instead*/) override {
        next_.error(InputError(where, message));
    }
    void error(const InputError& error) override { next_.error(error); }

  private:
    Diagnostics& next_;
};

void create_chosen(RenderSession& session, const CommandLine& command,
                   const IntegratorChoice& choice, Diagnostics& diagnostics) {
    FirmDiagnostics firm(diagnostics);
    const ParameterReader reader(choice.parameters, choice.integrator->plugin->parameters,
                                 choice.of_luxrender ? diagnostics : firm);
    session.integrator_name = choice.parameters.plugin;
    session.seed = choose_seed(command, reader);
    session.integrator = create_integrator(*choice.integrator, reader);
}

/// What stands in the scene's text is in the fingerprint already.
void complete_fingerprint(RenderSession& session, const CommandLine& command,
                          const IntegratorChoice& choice, const ReadFiles& files) {
    Fingerprint& fingerprint = session.fingerprint;
    try {
        if (command.checkpoint || command.mpi) fingerprint.set_program(choice.integrator->file);
        fingerprint.set_assets(files);
    } catch (const std::system_error& error) {
        throw SceneFailure(error.what());
    }
    fingerprint.set_settings(command, session.integrator_name, session.film->width(),
                             session.film->height());
    fingerprint.set_seed(session.seed);
}

/// Finds the files that lights and the film name, and adds them to `files`.
auto file_resolver(const SceneContents& contents, ReadFiles& files, Diagnostics& diagnostics) {
    const auto finder = std::make_shared<AssetFinder>(contents.directory);
    return [finder, &files, &diagnostics](const std::string& name, const SourceLocation& where) {
        return files.assets.emplace_back(finder->find(name, where, diagnostics));
    };
}

/// Throws OutputFailure if a file of the scene's is written.
void check_reads(const WrittenFiles& written, std::span<const std::string> files) {
    for (const std::string& file : files)
        written.check_read({"the scene's file", file});
}

/// The files that the render writes. Throws OutputFailure if one can't be written, or would replace
/// another one or what the render reads. `sources`: the scene and what it includes.
WrittenFiles check_outputs(const CommandLine& command, const OutputFiles& files,
                           std::span<const std::string> sources, const LoadedIntegrator& integrator,
                           ConsoleLog& log) {
    const std::string merged = command.merged_output.value_or("");
    for (const std::string& path : {files.exr, files.png, files.statistics, merged})
        check_writable(path, log);
    WrittenFiles written({{"the image", files.exr},
                          {"the PNG", files.png},
                          {"the statistics", files.statistics},
                          {"the checkpoint", command.checkpoint.value_or("")},
                          {"what is learned", command.learned_out.value_or("")},
                          {"the merged image", merged}});
    if (command.scene != "-") written.check_read({"the scene", command.scene});
    check_reads(written, sources.subspan(std::min<std::size_t>(1, sources.size())));
    written.check_read({"the plugin module", integrator.file.string()});
    if (command.learned_in) {
        // It is read by now; but a checkpoint is resumed with it.
        written.check_read({"that of --learned-in,", *command.learned_in},
                           command.checkpoint ? "" : "what is learned");
    }
    return written;
}

/// `whole`: all of the world was read. What was not may have been its lights.
void build_scene(RenderSession& session, SceneContents contents, bool whole, ReadFiles& files,
                 Diagnostics& diagnostics) {
    const SourceLocation end = contents.end;
    session.implied_material = contents.implied_material;
    if (session.film && session.film->hides_background()) {
        for (LightDescription& light : contents.lights)
            light.hidden = true;
    }
    const auto resolve = file_resolver(contents, files, diagnostics);
    session.scene = make_trace_scene(std::move(contents), resolve, diagnostics);
    if (whole && session.scene->lights().empty()) {
        throw InputError(end,
                         "the scene has no light: expected a LightSource, or a Shape after an "
                         "AreaLightSource");
    }
}

/// Why a scene is to be rendered by wavelengths; empty if it isn't: they are worth their price only
/// where something bends each its own way, or where RGB misrepresents spectra that the scene gives.
std::string reason_for_wavelengths(const TraceScene& scene) {
    const SpectralNeed& need = scene.spectral_need();
    std::string reason;
    if (scene.facts().disperses) reason = "a material disperses light";
    if (need.misrepresented()) {
        reason += fmt::format("{}RGB misrepresents {} by {:.0f} % of its colour",
                              reason.empty() ? "" : ", and ", need.worst.pair,
                              100 * need.worst.difference);
    }
    return reason;
}

void choose_spectral(RenderSession& session, ConsoleLog& log) {
    const std::string reason = reason_for_wavelengths(*session.scene);
    if (reason.empty()) return;
    if (session.sampler->metropolis() || !session.integrator->passes_stand_alone()) {
        log.warning(
            fmt::format("\"{}\" carries light from pass to pass here, so that passes can't differ "
                        "in wavelength: dispersion is left out, the index of 550 nm is used, and "
                        "spectra are rendered by their RGB colours ({})",
                        session.integrator_name, reason));
        return;
    }
    session.spectral = true;
    session.wavelength_density = session.scene->wavelength_density();
    log.info(fmt::format("rendering by wavelengths, three a pass, as {}", reason));
}

/// Gives scene and film the wavelengths of pass `pass`.
void begin_spectral_pass(RenderSession& session, std::uint64_t pass) {
    const Wavelengths wavelengths =
        wavelengths_of_pass(session.seed, pass, session.wavelength_density);
    session.scene->set_wavelengths(wavelengths);
    session.film->set_wavelengths(wavelengths);
}

/// Takes `step`; an error in it is gathered with those of others.
void gather(Diagnostics& diagnostics, const auto& step) {
    try {
        step();
    } catch (const InputError& error) {
        diagnostics.error(error);
    }
}

/// Tells what is wrong with the camera where the film, whose frame it takes, could not be made.
void check_camera_alone(const SceneContents& contents, Diagnostics& diagnostics) {
    SceneContents without_film;
    without_film.options = contents.options;
    without_film.end = contents.end;
    for (const char* statement : {"Film", "PixelFilter"})
        without_film.options.erase(statement);
    const auto film = make_film(without_film, diagnostics);
    make_camera(without_film, *film, diagnostics);
}

IntegratorChoice make_from_options(RenderSession& session, const CommandLine& command,
                                   const SceneContents& contents, ReadFiles& files,
                                   const PluginLibrary& plugins, InputDiagnostics& diagnostics,
                                   ConsoleLog& log) {
    IntegratorChoice choice;
    gather(diagnostics, [&] {
        choice = choose_integrator(command, contents, plugins, diagnostics, log);
        create_chosen(session, command, choice, diagnostics);
    });
    gather(diagnostics, [&] {
        session.film =
            make_film(contents, diagnostics, file_resolver(contents, files, diagnostics));
        session.film->set_exposure(command.exposure_stops);
    });
    gather(diagnostics, [&] {
        if (!session.film) return check_camera_alone(contents, diagnostics);
        session.camera = make_camera(contents, *session.film, diagnostics);
    });
    gather(diagnostics, [&] {
        const bool chains = choice.integrator && choice.integrator->plugin->runs_metropolis;
        const bool draws_lens = !session.camera || session.camera->has_lens();
        session.sampler = make_sampler(contents, session.seed, diagnostics, chains,
                                       draws_lens ? LensUse::Drawn : LensUse::None);
    });
    return choice;
}

RenderSession prepare(const CommandLine& command, const PluginLibrary& plugins,
                      InputDiagnostics& diagnostics, ConsoleLog& log) {
    RenderSession session;
    SceneContents contents;
    ReadFiles files;
    std::vector<std::string> sources;
    {
        const PhaseTimer timer(session.times, "load");
        contents = load(command.scene, diagnostics, files);
        apply_statement_overrides(command, contents, log);
        session.fingerprint.set_sources(files);
        for (const auto& source : files.sources)
            sources.push_back(source->name);
        forget_sources(files);
    }
    const bool whole = diagnostics.errors() == 0;
    const PhaseTimer timer(session.times, "build");
    std::optional<WrittenFiles> written;
    const IntegratorChoice choice =
        make_from_options(session, command, contents, files, plugins, diagnostics, log);
    if (diagnostics.errors() == 0 && command.writes) {  // before the scene takes its time to build
        session.files = choose_output_files(command, *session.film, log);
        if (!command.helps) {
            written = check_outputs(command, session.files, sources, *choice.integrator, log);
            check_reads(*written, files.assets);
        }
    }
    const std::size_t known = files.assets.size();
    const bool has_world = contents.end.line > 0;
    gather(diagnostics, [&] {
        if (has_world) build_scene(session, std::move(contents), whole, files, diagnostics);
    });
    diagnostics.refuse_errors();
    if (written) check_reads(*written, std::span(files.assets).subspan(known));
    complete_fingerprint(session, command, choice, files);
    choose_spectral(session, log);
    if (session.spectral) begin_spectral_pass(session, 0);
    session.film->set_names(session.scene->object_names(), session.scene->material_names());
    session.camera->focus(*session.scene);
    session.camera->set_media(session.scene->camera_media());
    return session;
}

}  // namespace

PassReport render_pass(RenderSession& session, std::uint64_t pass) {
    if (session.spectral) begin_spectral_pass(session, pass);
    return session.integrator->render_pass(pass);
}

RenderSession prepare_session(const CommandLine& command, const PluginLibrary& plugins,
                              InputDiagnostics& diagnostics, ConsoleLog& log) {
    std::optional<RenderSession> session;
    try {
        gather(diagnostics, [&] { session = prepare(command, plugins, diagnostics, log); });
    } catch (...) {
        diagnostics.report();
        throw;
    }
    diagnostics.report();
    diagnostics.refuse_errors();
    return std::move(*session);
}

}  // namespace lxs
