// One render with its times, memory and snapshots: what happens inside a run's own process.
#pragma once

#include "lxs/host/console_log.h"
#include "run_settings.h"

namespace bench {

/// Renders and writes the snapshots; returns what was measured (see
/// docs/reference/benchmark-files.md, without the errors). Throws as lxs::prepare_session does,
/// lxs::SceneFailure, lxs::OutputFailure.
Json measured_render(const RenderJob& job, lxs::ConsoleLog& log);

}  // namespace bench
