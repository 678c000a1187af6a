// The JSON file that a render leaves beside its image.
#pragma once

#include <optional>
#include <string>

#include "lxs/host/advice.h"
#include "lxs/host/image_verdict.h"
#include "lxs/host/invalid_sample_report.h"
#include "lxs/host/progress.h"
#include "lxs/host/render_session.h"

namespace lxs {

/// What the parts of a render say of it.
struct RenderFigures {
    Statistics own;  ///< the integrator's
    InvalidSamplesByKind refused;
    std::optional<ImageVerdict> image;             ///< none: it was not looked at
    std::optional<TransportStatistics> transport;  ///< none: not asked for
    std::vector<Advice> advice;
};

/// Settings, scene facts, times by phase, counts and speeds, memory, the integrator's own figures.
std::string statistics_json(const CommandLine& command, const RenderSession& session,
                            const RenderTotals& totals, const RenderFigures& figures,
                            bool interrupted);

}  // namespace lxs
