// What the parts of a render say of it, for its statistics and for the end of its log.
#pragma once

#include <optional>
#include <vector>

#include "lxs/host/advice.h"
#include "lxs/host/image_verdict.h"
#include "lxs/host/invalid_sample_report.h"
#include "lxs/host/render_session.h"

namespace lxs {

struct RenderFigures {
    Statistics own;  ///< the integrator's
    InvalidSamplesByKind refused;
    std::optional<ImageVerdict> image;             ///< none: it was not looked at
    std::optional<TransportStatistics> transport;  ///< none: not asked for
    std::vector<Advice> advice;
    bool failed = false;  ///< the integrator did not say all; the log has the reason
};

/// What the integrator says; `own`: with figures of its own.
RenderFigures ask_integrator(const CommandLine& command, const RenderSession& session, bool own,
                             ConsoleLog& log);

/// Looks at the image, and for advice if the integrator was asked for it.
void look_at_image(RenderSession& session, RenderFigures& figures);

/// Logs what is worth knowing at the end of a render: what was refused, why the image shows
/// nothing, what became of its light.
void log_figures(const CommandLine& command, const RenderSession& session,
                 const RenderFigures& figures, ConsoleLog& log);

}  // namespace lxs
