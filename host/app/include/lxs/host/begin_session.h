// From a scene that is ready to its first pass.
#pragma once

#include "lxs/host/console_log.h"
#include "lxs/host/render_session.h"

namespace lxs {

/// What the scene has, and what is skipped as it has none.
void log_scene(const RenderSession& session, ConsoleLog& log);

/// To be called once, before the first pass. Throws SceneFailure if the integrator can't render the
/// scene, InputError, PluginFailure.
void prepare_integrator(RenderSession& session, const CommandLine& command, ConsoleLog& log);

}  // namespace lxs
