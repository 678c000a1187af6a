// A scene made ready to render: read, checked, built.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "lxs/host/command_line.h"
#include "lxs/host/fingerprint.h"
#include "lxs/host/input_diagnostics.h"
#include "lxs/host/integrator_choice.h"
#include "lxs/host/output_files.h"
#include "lxs/host/plugin_library.h"
#include "lxs/host/rank_job.h"
#include "lxs/imaging/imaging.h"
#include "lxs/tracing/trace_scene.h"

namespace lxs {

/// Seconds of wall time by phase: load, build, render, write.
using PhaseTimes = std::map<std::string, double>;

/// Owns the host's part of a render. The plugin library must outlive it.
struct RenderSession {
    std::unique_ptr<FileFilm> film;
    std::unique_ptr<SceneCamera> camera;
    std::unique_ptr<Sampler> sampler;
    std::unique_ptr<TraceScene> scene;
    std::unique_ptr<Film> no_film;  ///< what the integrator is given by a rank that helps
    std::unique_ptr<Integrator> integrator;
    std::string integrator_name;
    std::optional<std::uint32_t> implied_material;  ///< as SceneContents has it
    std::uint64_t seed = 0;
    OutputFiles files;
    PhaseTimes times;
    RankJob* job = nullptr;   ///< of --mpi
    Fingerprint fingerprint;  ///< that of the program is left out where no checkpoint is asked for
    bool spectral = false;    ///< each pass has wavelengths of its own
    WavelengthDensity wavelength_density;  ///< that these are drawn from
};

/// Everything that can be wrong with the input or the output's place is found here, and reported.
/// Throws RefusedInput, SceneFailure (a file can't be read), PluginFailure, OutputFailure.
RenderSession prepare_session(const CommandLine& command, const PluginLibrary& plugins,
                              InputDiagnostics& diagnostics, ConsoleLog& log);

/// Renders pass number `pass` with the session's integrator, which is prepared: by wavelengths of
/// its own if the session is spectral.
PassReport render_pass(RenderSession& session, std::uint64_t pass);

}  // namespace lxs
