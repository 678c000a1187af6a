// Which integrator renders a scene, and with which parameters.
#pragma once

#include "lxs/host/command_line.h"
#include "lxs/host/plugin_library.h"
#include "lxs/scene/contents.h"
#include "lxs/sdk/diagnostics.h"
#include "lxs/sdk/log.h"

namespace lxs {

/// An integrator of a module with the parameters that the scene and the command line give it.
struct IntegratorChoice {
    const LoadedIntegrator* integrator = nullptr;
    ParameterSet parameters;
    /// The scene asks for one that LuxRender has: wrong values are read as LuxRender reads them.
    bool of_luxrender = false;
};

/// From --integrator, else SurfaceIntegrator, else a Renderer that implies one, else `path`. With
/// --integrator the scene's parameters stay as far as the integrator declares them. Also checks the
/// names in Renderer, VolumeIntegrator and Accelerator. Throws InputError if there is no such
/// integrator.
IntegratorChoice choose_integrator(const CommandLine& command, const SceneContents& contents,
                                   const PluginLibrary& plugins, Diagnostics& diagnostics,
                                   Log& log);

}  // namespace lxs
