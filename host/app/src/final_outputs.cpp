// What a render leaves behind: its images and its statistics, also when it ended before its time.
#include "lxs/host/final_outputs.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <span>

#include "lxs/host/counted.h"
#include "lxs/host/process_usage.h"
#include "lxs/host/render_figures.h"
#include "lxs/host/rescue.h"
#include "lxs/host/seconds_since.h"
#include "lxs/host/statistics_file.h"
#include "lxs/imaging/atomic_file.h"
#include "lxs/imaging/image_header.h"

namespace lxs {
namespace {

bool write_images_timed(const CommandLine& command, RenderSession& session,
                        const RenderTotals& totals, ConsoleLog& log) {
    const auto start = std::chrono::steady_clock::now();
    const bool in_place =
        write_images(session.files, *session.film, image_metadata(command, session, totals), log);
    session.times["write"] += seconds_since(start);
    return in_place;
}

bool write_text(const std::string& path, const std::string& text, ConsoleLog& log) {
    const auto write = [&](const std::string& target) {
        write_file_atomically(target, std::as_bytes(std::span(text)));
    };
    return write_or_rescue(path, write, log);
}

}  // namespace

ImageMetadata image_metadata(const CommandLine& command, const RenderSession& session,
                             const RenderTotals& totals) {
    namespace header = image_header;
    ImageMetadata metadata{{header::kIntegrator, session.integrator_name},
                           {header::kPasses, fmt::to_string(totals.passes)},
                           {header::kSamples, fmt::to_string(totals.samples_per_pixel)},
                           {header::kScene, std::filesystem::path(command.scene).filename()},
                           {header::kSeed, fmt::to_string(session.seed)},
                           {header::kSoftware, "lxsrender " + version()}};
    session.fingerprint.describe(metadata);
    if (const auto error = session.film->error()) describe(*error, metadata);
    return metadata;
}

ExitCode write_final_outputs(const CommandLine& command, RenderSession& session,
                             const RenderTotals& totals, bool interrupted, ConsoleLog& log) {
    bool in_place = write_images_timed(command, session, totals, log);
    if (in_place) log.info("wrote " + names_of_images(session.files));
    RenderFigures figures =
        ask_integrator(command, session, !session.files.statistics.empty(), log);
    look_at_image(session, figures);
    if (!session.files.statistics.empty()) {
        const std::string text = statistics_json(command, session, totals, figures, interrupted);
        in_place = write_text(session.files.statistics, text, log) && in_place;
    }
    log_figures(command, session, figures, log);
    if (const std::uint64_t bytes = peak_resident_bytes())
        log.debug(fmt::format("memory: at most {} MB were in use", bytes / 1'000'000));
    if (interrupted) log.warning("interrupted after " + counted(totals.passes, "pass", "passes"));
    if (!in_place) return ExitCode::OutputFailure;
    if (figures.failed) return ExitCode::PluginFailure;
    return interrupted ? ExitCode::Interrupted : ExitCode::Success;
}

void save_finished_passes(const CommandLine& command, RenderSession& session,
                          const RenderTotals& totals, ConsoleLog& log) try {
    if (totals.passes == 0) return;
    std::string statistics;
    RenderFigures figures;
    try {
        figures = ask_integrator(command, session, !session.files.statistics.empty(), log);
        if (!session.files.statistics.empty()) {
            statistics = statistics_json(command, session, totals, figures, true);
        }
    } catch (const std::exception&) {
        statistics.clear();  // the image matters more, and memory may be what is missing
    }
    session.integrator.reset();
    session.scene.reset();
    const bool in_place = write_images_timed(command, session, totals, log);
    if (!statistics.empty()) write_text(session.files.statistics, statistics, log);
    warn_of_invalid_samples(figures.refused, log);
    if (in_place) {
        log.warning(fmt::format("the render ends early: {} finished passes are in {}",
                                totals.passes, names_of_images(session.files)));
    }
} catch (const std::exception& error) {
    log.error(fmt::format("the finished passes could not be saved: {}", error.what()));
}

}  // namespace lxs
