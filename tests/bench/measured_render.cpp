// One render with its times, memory and snapshots: what happens inside a run's own process.
#include "measured_render.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "lxs/host/failure.h"
#include "lxs/host/process_usage.h"
#include "lxs/host/render_session.h"
#include "lxs/host/seconds_since.h"
#include "lxs/host/thread_count.h"
#include "pass_trace.h"
#include "time_marks.h"

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;

lxs::CommandLine command_line(const RenderJob& job) {
    const RunSettings& settings = job.settings;
    lxs::CommandLine command;
    command.scene = settings.scene_file;
    command.output = job.images + ".exr";
    command.threads = settings.threads;
    command.seed = settings.seed;
    command.overrides = settings.set;
    command.integrator = settings.integrator;
    if (settings.width_px > 0) command.width = settings.width_px;
    if (settings.height_px > 0) command.height = settings.height_px;
    if (!settings.sampler.empty()) command.sampler = settings.sampler;
    return command;
}

Json to_json(const PassTotals& totals) {
    return {{"pass", totals.passes}, {"wall_s", totals.wall_s},
            {"cpu_s", totals.cpu_s}, {"photon_paths", totals.photon_paths},
            {"rays", totals.rays},   {"resident_bytes", totals.resident_bytes}};
}

Json to_json(const std::vector<TimeMark>& marks) {
    Json list = Json::array();
    for (const TimeMark& mark : marks)
        list.push_back({{"clock", mark.clock}, {"seconds", mark.seconds}});
    return list;
}

/// The passes of a render; clocks run in the passes alone.
class MeasuredPasses {
  public:
    MeasuredPasses(const RenderJob& job, lxs::RenderSession& session)
        : job_(job),
          session_(session),
          marks_(job.settings.budgets_s, job.settings.clock),
          pass_marks_(job.settings.passes) {}

    void render() {
        while (!all_passed()) {
            render_pass();
            const std::vector<TimeMark> due = marks_.due(totals_.cpu_s, totals_.wall_s);
            const bool pass_due = pass_marks_.due(totals_.passes);
            const bool wanted =
                job_.final_only ? all_passed() : totals_.passes == 1 || pass_due || !due.empty();
            if (wanted) take_snapshot(due);
        }
    }

    Json report() const {
        Json trace = Json::array();
        for (const PassTotals& entry : trace_.entries())
            trace.push_back(to_json(entry));
        return {{"totals",
                 {{"passes", totals_.passes},
                  {"photon_paths", totals_.photon_paths},
                  {"rays", totals_.rays},
                  {"samples_per_pixel", totals_.samples_per_pixel}}},
                {"peak_memory_bytes", peak_bytes_},
                {"trace", trace},
                {"snapshots", snapshots_}};
    }
    const PassTotals& totals() const { return totals_; }
    double snapshots_s() const { return snapshots_s_; }

  private:
    bool all_passed() const { return marks_.all_passed() && pass_marks_.all_passed(); }

    void render_pass() {
        const auto wall = Clock::now();
        const double cpu = lxs::cpu_seconds();
        const lxs::PassReport report = lxs::render_pass(session_, totals_.passes);
        totals_.wall_s += lxs::seconds_since(wall);
        totals_.cpu_s += lxs::cpu_seconds() - cpu;
        ++totals_.passes;
        totals_.photon_paths += report.photon_paths;
        totals_.rays += report.rays;
        totals_.samples_per_pixel += report.samples_per_pixel;
        totals_.resident_bytes = lxs::resident_bytes();
        peak_bytes_ = lxs::peak_resident_bytes();
        trace_.add(totals_);
    }

    void take_snapshot(const std::vector<TimeMark>& due) {
        const auto start = Clock::now();
        const std::string stem = fmt::format("{}.{}", job_.images, snapshots_.size());
        lxs::OutputFiles files{stem + ".exr", stem + ".png", ""};
        try {
            session_.film->write_exr(files.exr, {});
            if (job_.png) session_.film->write_png(files.png);
        } catch (const std::runtime_error& error) {
            throw lxs::OutputFailure(error.what());
        }
        Json snapshot = to_json(totals_);
        snapshot["samples_per_pixel"] = totals_.samples_per_pixel;
        snapshot["marks"] = to_json(due);
        snapshot["exr"] = files.exr;
        snapshot["png"] = job_.png ? Json(files.png) : Json();
        snapshots_.push_back(std::move(snapshot));
        snapshots_s_ += lxs::seconds_since(start);
    }

    const RenderJob& job_;
    lxs::RenderSession& session_;
    TimeMarks marks_;
    PassMarks pass_marks_;
    PassTotals totals_;
    PassTrace trace_;
    Json snapshots_ = Json::array();
    std::uint64_t peak_bytes_ = 0;
    double snapshots_s_ = 0;
};

/// Seconds of wall time.
double prepare(const RenderJob& job, lxs::RenderSession& session, lxs::Log& log) {
    const auto start = Clock::now();
    try {
        session.integrator->prepare({*session.scene,
                                     *session.camera,
                                     *session.sampler,
                                     *session.film,
                                     log,
                                     {job.settings.threads, session.seed}});
    } catch (const lxs::InputError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw lxs::SceneFailure(error.what());
    }
    return lxs::seconds_since(start);
}

Json own_statistics(const lxs::RenderSession& session) {
    Json json = Json::object();
    for (const auto& [name, value] : session.integrator->statistics()) {
        std::visit([&, &key = name](const auto& figure) { json[key] = figure; }, value);
    }
    return json;
}

Json render_and_measure(const RenderJob& job, lxs::ConsoleLog& log) {
    lxs::PluginLibrary plugins;
    plugins.load_folder(lxs::own_plugin_folder());
    lxs::InputDiagnostics diagnostics(log, false);
    lxs::RenderSession session = lxs::prepare_session(command_line(job), plugins, diagnostics, log);
    const double prepare_s = prepare(job, session, log);
    MeasuredPasses passes(job, session);
    passes.render();
    Json json = passes.report();
    json["image"] = {{"width_px", session.film->width()}, {"height_px", session.film->height()}};
    json["phases"] = {{"load_s", session.times["load"]},
                      {"build_s", session.times["build"]},
                      {"prepare_s", prepare_s},
                      {"render_wall_s", passes.totals().wall_s},
                      {"render_cpu_s", passes.totals().cpu_s},
                      {"snapshots_s", passes.snapshots_s()}};
    json["refused_film_samples"] = session.film->refused_samples();
    json["integrator_statistics"] = own_statistics(session);
    return json;
}

}  // namespace

Json measured_render(const RenderJob& job, lxs::ConsoleLog& log) {
    return lxs::on_threads(job.settings.threads, [&] { return render_and_measure(job, log); });
}

}  // namespace bench
