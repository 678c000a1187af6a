// The image so far, written while a render goes on.
#include "lxs/host/snapshots.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <new>

#include "lxs/host/final_outputs.h"
#include "lxs/host/seconds_since.h"

namespace lxs {
namespace {

WriteSchedule exr_schedule(const CommandLine& command, const FileFilm& film) {
    if (command.write_every) return {*command.write_every, WriteCost::Whatever};
    return {film.write_interval_seconds(), WriteCost::Bounded};
}

/// LuxRender shows the image in its window by displayinterval; here the PNG does.
WriteSchedule png_schedule(const CommandLine& command, const FileFilm& film) {
    WriteSchedule schedule = exr_schedule(command, film);
    const double shown = film.display_interval_seconds();
    if (command.write_every || shown <= 0) return schedule;
    return {std::min(schedule.interval(), shown), WriteCost::Bounded};
}

/// A viewer follows a render that is watched: often, as far as that costs little.
WriteSchedule viewer_schedule() {
    constexpr double kSeconds = 1;
    return {kSeconds, WriteCost::Bounded};
}

std::optional<DisplayServer> choose_display(const CommandLine& command) {
    if (!command.display_server) return std::nullopt;
    return DisplayServer(ViewerAddress::parse(*command.display_server),
                         std::filesystem::path(command.scene).filename().string());
}

/// Calls `write`; gives the seconds that it took. What it throws is a warning.
template <class Write>
double write_timed(ConsoleLog& log, const Write& write) {
    const auto start = std::chrono::steady_clock::now();
    try {
        write();
    } catch (const std::bad_alloc&) {
        log.warning("no memory to write the image so far; rendering goes on");
    } catch (const std::exception& error) {
        log.warning(
            fmt::format("{}; rendering goes on, and writing is tried again later", error.what()));
    }
    return seconds_since(start);
}

}  // namespace

Snapshots::Snapshots(const CommandLine& command, RenderSession& session, const Budget& budget,
                     ConsoleLog& log)
    : command_(command),
      session_(session),
      budget_(budget),
      log_(log),
      exr_(exr_schedule(command, *session.film)),
      png_(png_schedule(command, *session.film)),
      viewer_(viewer_schedule()),
      display_(choose_display(command)) {}

void Snapshots::between_passes(const RenderTotals& totals) {
    const auto left = budget_.remaining(totals.passes, totals.seconds);
    if (!session_.files.png.empty() && png_.due(totals.seconds, left)) write_png(totals);
    if (!session_.files.exr.empty() && exr_.due(totals.seconds, left)) write_exr(totals);
    if (display_ && viewer_.due(totals.seconds, left)) show(totals);
}

void Snapshots::finish(const RenderTotals& totals) {
    if (display_ && totals.passes > 0) show(totals);
}

void Snapshots::write_exr(const RenderTotals& totals) {
    const double took = write_timed(log_, [&] {
        session_.film->write_exr(session_.files.exr, image_metadata(command_, session_, totals),
                                 denoised());
    });
    session_.times["write"] += took;
    exr_.written(totals.seconds, took);
}

void Snapshots::write_png(const RenderTotals& totals) {
    const double took = write_timed(log_, [&] {
        session_.film->write_png(session_.files.png, denoised());
        say_where();
    });
    session_.times["write"] += took;
    png_.written(totals.seconds, took);
}

void Snapshots::show(const RenderTotals& totals) {
    const auto start = std::chrono::steady_clock::now();
    try {
        const FileFilm& film = *session_.film;
        display_->show(film.width(), film.height(), film.shown());
    } catch (const std::exception& error) {
        if (!said_no_viewer_)
            log_.warning(fmt::format("{}; rendering goes on, and the viewer is tried again later",
                                     error.what()));
        said_no_viewer_ = true;
    }
    const double took = seconds_since(start);
    session_.times["write"] += took;
    viewer_.written(totals.seconds, took);
}

std::vector<Rgb> Snapshots::denoised() const {
    if (command_.denoise == Denoising::Last) return {};
    return session_.film->denoised();
}

void Snapshots::say_where() {
    if (said_where_) return;
    said_where_ = true;
    log_.info(fmt::format("the picture so far is in {}; it is written anew about every {} s",
                          session_.files.png, png_.interval()));
}

}  // namespace lxs
