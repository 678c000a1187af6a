// A render watched in a browser: what it shows there, and what it is told from there.
#include "lxs/host/live_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <system_error>

#include "live_state.h"
#include "lxs/host/failure.h"
#include "lxs/host/seconds_since.h"
#include "lxs/host/write_schedule.h"
#include "lxs/serve/live_server.h"

namespace lxs {
namespace {

using std::chrono::milliseconds;

/// Least seconds of passes from image to image; more where making them takes 1 % of the time.
constexpr double kBetweenImages = 0.4;
/// Least seconds from state to state: two to each question of a page.
constexpr double kBetweenStates = 0.25;
/// How long a render that has ended waits for those who watch.
constexpr milliseconds kFarewell{2500};
/// How often a render that is paused looks for signals.
constexpr milliseconds kHeartbeat{100};

}  // namespace

class LiveView::Show {
  public:
    Show(const CommandLine& command, RenderSession& session, const Budget& budget, ConsoleLog& log)
        : command_(command), session_(session), budget_(budget), log_(log) {
        put_state("preparing", {});
        try {
            server_ = std::make_unique<serve::LiveServer>(board_, *command.serve);
        } catch (const std::system_error& error) {
            throw OutputFailure(fmt::format("cannot listen on 127.0.0.1:{}: {}", *command.serve,
                                            error.code().message()));
        }
        log.verbatim("watch it in a browser: " + server_->link());
    }

    void pass_done(const RenderTotals& totals, ErrorWatch& error, Interruption& interruption) {
        note_error(totals, error);
        obey(interruption);
        if (!board_.watched()) return;
        const auto left = budget_.remaining(totals.passes, totals.seconds);
        if (images_.due(totals.seconds, left)) {
            put_pictures(totals);
        } else if (!state_shown_ || seconds_since(*state_shown_) >= kBetweenStates) {
            put_state("rendering", totals);
        }
    }

    void wait_while_paused(const RenderTotals& totals, ErrorWatch& error,
                           Interruption& interruption) {
        if (!board_.orders().pause || interruption.requested()) return;
        log_.info(fmt::format("paused from the page after {} passes", totals.passes));
        note_error(totals, error);
        put_pictures(totals);
        const auto start = std::chrono::steady_clock::now();
        while (board_.orders().pause && !interruption.requested()) {
            put_state("paused", totals);
            if (board_.watched() && image_passes_ != totals.passes) put_image(totals);
            put_layer(totals);
            board_.wait_for_wishes(kHeartbeat);
            obey(interruption);
        }
        paused_seconds_ += seconds_since(start);
        put_state("rendering", totals);
        if (!interruption.requested()) log_.info("the render goes on");
    }

    void passes_over(const RenderTotals& totals, ErrorWatch& error) {
        note_error(totals, error);
        if (board_.watched() && totals.passes > 0) {
            if (image_passes_ != totals.passes) put_image(totals);
            put_layer(totals);
        }
        put_state("saving", totals);
    }

    void ended(const RenderTotals& totals, bool written) {
        message_ = written ? "Written: " + names_of_images(session_.files)
                           : "Not all is written as it should be: see what lxsrender says.";
        put_state("ended", totals);
        board_.wait_until_seen(kFarewell);
    }

    double paused_seconds() const { return paused_seconds_; }

  private:
    void obey(Interruption& interruption) {
        if (board_.orders().stop) interruption.request("whoever watches its page");
    }

    void note_error(const RenderTotals& totals, ErrorWatch& error) {
        target_error_ = error.target();
        curve_.add(totals, error.recent(totals));
    }

    void put_state(const char* phase, const RenderTotals& totals) {
        state_shown_ = std::chrono::steady_clock::now();
        if (totals.passes > 0) find_layers();
        board_.put_state(live_state_json(command_, session_, budget_,
                                         {.phase = phase,
                                          .message = message_,
                                          .totals = totals,
                                          .target_error = target_error_,
                                          .curve = curve_,
                                          .layers = layers_,
                                          .transport = transport_}));
    }

    /// Layers keep their numbers when new ones come.
    void find_layers() {
        for (const std::string& name : session_.film->held_layers()) {
            if (std::find(layers_.begin(), layers_.end(), name) == layers_.end())
                layers_.push_back(name);
        }
    }

    void put_pictures(const RenderTotals& totals) {
        const auto start = std::chrono::steady_clock::now();
        if (command_.advice && totals.passes > 0)
            transport_ = session_.integrator->transport_statistics();
        put_image(totals);
        put_layer(totals);
        put_state("rendering", totals);
        const double took = seconds_since(start);
        session_.times["write"] += took;
        images_.written(totals.seconds, took);
    }

    void put_image(const RenderTotals& totals) {
        const FileFilm& film = *session_.film;
        const std::vector<Rgb> image = film.shown();
        static_assert(sizeof(Rgb) == 3 * sizeof(float));
        const std::span<const float> values(&image.data()->x, 3 * image.size());
        ++number_;
        board_.put_image(serve::picture_bytes(film.width(), film.height(), 3, number_, values),
                         number_);
        image_passes_ = totals.passes;
    }

    void put_layer(const RenderTotals& totals) {
        const auto wanted = board_.wanted_layer();
        if (!wanted || *wanted >= layers_.size()) return;
        if (layer_passes_ == totals.passes && layer_shown_ == wanted) return;
        const FileFilm& film = *session_.film;
        const HeldLayer layer = film.held_layer(layers_[*wanted]);
        if (layer.values.empty()) return;
        ++number_;
        board_.put_layer(*wanted,
                         serve::picture_bytes(film.width(), film.height(), layer.channels, number_,
                                              layer.values),
                         number_);
        layer_shown_ = wanted;
        layer_passes_ = totals.passes;
    }

    const CommandLine& command_;
    RenderSession& session_;
    const Budget& budget_;
    ConsoleLog& log_;
    serve::Board board_;
    std::unique_ptr<serve::LiveServer> server_;  ///< before the board ends
    WriteSchedule images_{kBetweenImages, WriteCost::Bounded};
    ErrorCurve curve_;
    std::optional<double> target_error_;
    std::optional<TransportStatistics> transport_;
    std::vector<std::string> layers_;
    std::string message_;
    std::uint32_t number_ = 0;        ///< of the last picture
    std::uint64_t image_passes_ = 0;  ///< that the image shown is of
    std::uint64_t layer_passes_ = 0;
    std::optional<std::size_t> layer_shown_;
    std::optional<std::chrono::steady_clock::time_point> state_shown_;
    double paused_seconds_ = 0;
};

LiveView::LiveView(const CommandLine& command, RenderSession& session, const Budget& budget,
                   ConsoleLog& log)
    : show_(command.serve ? std::make_unique<Show>(command, session, budget, log) : nullptr) {}
LiveView::~LiveView() = default;

void LiveView::pass_done(const RenderTotals& totals, ErrorWatch& error,
                         Interruption& interruption) {
    if (show_) show_->pass_done(totals, error, interruption);
}

void LiveView::wait_while_paused(const RenderTotals& totals, ErrorWatch& error,
                                 Interruption& interruption) {
    if (show_) show_->wait_while_paused(totals, error, interruption);
}

void LiveView::passes_over(const RenderTotals& totals, ErrorWatch& error) {
    if (show_) show_->passes_over(totals, error);
}

void LiveView::ended(const RenderTotals& totals, bool written) {
    if (show_) show_->ended(totals, written);
}

double LiveView::paused_seconds() const {
    return show_ ? show_->paused_seconds() : 0;
}

}  // namespace lxs
