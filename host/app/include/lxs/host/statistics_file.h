// The JSON file that a render leaves beside its image.
#pragma once

#include <string>

#include "lxs/host/progress.h"
#include "lxs/host/render_figures.h"
#include "lxs/host/render_session.h"

namespace lxs {

/// Settings, scene facts, times by phase, counts and speeds, memory, the integrator's own figures.
std::string statistics_json(const CommandLine& command, const RenderSession& session,
                            const RenderTotals& totals, const RenderFigures& figures,
                            bool interrupted);

}  // namespace lxs
