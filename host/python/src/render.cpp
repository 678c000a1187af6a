// The steps of lxsrender, without files.
#include "render.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <utility>

#include "lxs/host/begin_session.h"
#include "lxs/host/failure.h"
#include "lxs/host/final_outputs.h"
#include "lxs/host/input_diagnostics.h"
#include "lxs/host/render_figures.h"
#include "lxs/host/render_loop.h"
#include "lxs/host/seconds_since.h"
#include "lxs/host/statistics_file.h"
#include "lxs/host/thread_count.h"

namespace lxs {
namespace {

/// Keeps the first error, with its place.
class FirstError final : public InputDiagnostics {
  public:
    using InputDiagnostics::InputDiagnostics;
    void error(const InputError& error) override {
        if (!first_) first_ = error;
        InputDiagnostics::error(error);
    }
    const std::optional<InputError>& first() const { return first_; }

  private:
    std::optional<InputError> first_;
};

std::optional<double> relative_error(const FileFilm& film) {
    const auto error = film.error();
    return error ? std::optional(error->relative()) : std::nullopt;
}

/// The result of `work`, while the modules are there that its errors may come from.
auto with_own_errors(const auto& work) {
    try {
        return work();
    } catch (const InputError& error) {
        throw Refusal(error.what(), error);
    } catch (const SceneFailure& failure) {
        throw Refusal(failure.what());
    }
}

}  // namespace

Refusal::Refusal(const std::string& text, const InputError& first)
    : std::runtime_error(text), message(first.message()) {
    const SourceLocation& where = first.where();
    if (!where.file || !where.file->text) return;  // it was given by the program
    file = where.file->name;
    line = where.line;
    column = where.column;
}

Render::Render(CommandLine command, MessageSink sink)
    : command_(std::move(command)),
      sink_(std::move(sink)),
      log_([this](MessageKind kind, std::string_view text) {
          if (kind >= MessageKind::VerbatimError && !session_) {
              errors_.emplace_back(text);
          } else {
              sink_(kind, text);
          }
      }) {
    command_.writes = false;
    with_own_errors([this] { on_threads(command_.threads, [this] { read(); }); });
    log_scene(*session_, log_);
}

void Render::read() {
    load_plugins(command_.plugin_paths, plugins_);
    FirstError diagnostics(log_, command_.strict);
    try {
        session_ = prepare_session(command_, plugins_, diagnostics, log_);
    } catch (const RefusedInput&) {
        const std::string text = fmt::format("{}", fmt::join(errors_, "\n"));
        throw Refusal(text, *diagnostics.first());
    }
    session_->film->estimate_errors(command_.error_estimate);
    session_->film->keep_for_denoising(command_.denoise != Denoising::None);
}

bool Render::run(const Ending& ending, const OnPass& on_pass) {
    std::unique_lock lock(mutex_);
    if (state_ == State::Running || state_ == State::Failed) return false;
    command_.passes = ending.passes;
    command_.seconds = ending.seconds;
    command_.target_error = ending.error;
    const bool prepared = std::exchange(state_, State::Running) == State::Prepared;
    try {
        with_own_errors(
            [&] { on_threads(command_.threads, [&] { render(prepared, on_pass, lock); }); });
    } catch (...) {
        state_ = State::Failed;
        throw;
    }
    state_ = State::Prepared;
    return true;
}

void Render::render(bool prepared, const OnPass& on_pass, std::unique_lock<std::mutex>& lock) {
    RenderSession& session = *session_;
    const auto start = std::chrono::steady_clock::now();
    const double before = session.times["render"];
    double elsewhere = 0;  // seconds
    if (!prepared) prepare_integrator(session, command_, log_);
    const Budget budget = choose_budget(command_, *session.film, log_);
    Interruption interruption(false);
    ErrorWatch error(*session.film, budget.error);
    Progress progress(log_, budget, error, false);
    RenderLoop loop{.session = session,
                    .budget = budget,
                    .interruption = interruption,
                    .progress = progress,
                    .error = error,
                    .end_pass = [&](const RenderTotals& totals) {
                        session.times["render"] = before + seconds_since(start) - elsewhere;
                        const auto left = std::chrono::steady_clock::now();
                        lock.unlock();
                        if (!on_pass(totals)) interruption.request("the program");
                        lock.lock();
                        elsewhere += seconds_since(left);
                    }};
    loop.run(totals_);
    stopped_ = interruption.requested();
}

std::vector<Rgb> Render::image() const {
    const std::lock_guard lock(mutex_);
    return session_->film->image();
}

RenderTotals Render::totals() const {
    const std::lock_guard lock(mutex_);
    return totals_;
}

std::optional<double> Render::error() const {
    const std::lock_guard lock(mutex_);
    return relative_error(*session_->film);
}

RenderedImage Render::result() {
    const std::lock_guard lock(mutex_);
    return on_threads(command_.threads, [this] {
        RenderSession& session = *session_;
        const FileFilm& film = *session.film;
        RenderedImage result;
        result.totals = totals_;
        result.stopped = stopped_;
        result.error = relative_error(film);
        result.layers =
            film.file_layers(image_metadata(command_, session, totals_), film.denoised());
        result.shown = film.tone_mapped();
        RenderFigures figures = ask_integrator(command_, session, true, log_);
        look_at_image(session, figures);
        result.statistics = statistics_json(command_, session, totals_, figures, stopped_);
        log_figures(command_, session, figures, log_);
        return result;
    });
}

}  // namespace lxs
