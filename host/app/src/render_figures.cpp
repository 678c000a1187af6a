// Integrator and image are asked, and their answers put into words.
#include "lxs/host/render_figures.h"

#include <fmt/format.h>

#include <chrono>

#include "lxs/host/explanation.h"
#include "lxs/host/failure.h"
#include "lxs/host/seconds_since.h"

namespace lxs {
namespace {

void warn_of_empty_image(const ImageVerdict& image, ConsoleLog& log) {
    if (image.reason.empty()) return;
    log.warning(
        fmt::format("the image is all {}; the likely reason: {}", image.name(), image.reason));
}

void explain(const CommandLine& command, const RenderSession& session, const RenderFigures& figures,
             ConsoleLog& log) {
    if (const std::string line = transport_line(*figures.transport); !line.empty()) log.info(line);
    for (const Advice& advice : figures.advice)
        log.info("advice: " + advice.text);
    if (command.explain) log.verbatim(explanation(session, *figures.transport));
}

}  // namespace

RenderFigures ask_integrator(const CommandLine& command, const RenderSession& session, bool own,
                             ConsoleLog& log) {
    RenderFigures figures;
    InvalidSampleList contributions;
    try {
        contributions = session.integrator->invalid_samples();
        if (own) figures.own = session.integrator->statistics();
        if (command.advice) figures.transport = session.integrator->transport_statistics();
    } catch (const PluginFailure& failure) {
        figures.failed = true;
        log.error(failure.what());
    }
    figures.refused = invalid_samples_by_kind(session, std::move(contributions));
    return figures;
}

void look_at_image(RenderSession& session, RenderFigures& figures) {
    figures.image = judge_image(session);
    if (!figures.transport) return;
    const auto start = std::chrono::steady_clock::now();
    figures.advice = advise(session, *figures.transport, *figures.image);
    session.times["advice"] = seconds_since(start);
}

void log_figures(const CommandLine& command, const RenderSession& session,
                 const RenderFigures& figures, ConsoleLog& log) {
    warn_of_invalid_samples(figures.refused, log);
    warn_of_empty_image(*figures.image, log);
    if (const auto share = session.film->outliers_left_out())
        log.info(
            fmt::format("outlierrejection_k leaves {:.2g} % of the light out of what is "
                        "displayed; the EXR has all of it",
                        100 * *share));
    if (figures.transport) explain(command, session, figures, log);
}

}  // namespace lxs
