// A render watched in a browser (--serve): what it shows there, and what it is told from there.
#pragma once

#include <memory>

#include "lxs/host/budget.h"
#include "lxs/host/command_line.h"
#include "lxs/host/console_log.h"
#include "lxs/host/error_watch.h"
#include "lxs/host/interruption.h"
#include "lxs/host/progress.h"
#include "lxs/host/render_session.h"

namespace lxs {

/// Does nothing at all without --serve, and hardly anything while nobody watches. The render's bits
/// are the same with and without.
class LiveView {
  public:
    /// Begins to serve and says where. Throws OutputFailure if the port can't be listened on.
    LiveView(const CommandLine& command, RenderSession& session, const Budget& budget,
             ConsoleLog& log);
    ~LiveView();
    LiveView(const LiveView&) = delete;
    LiveView& operator=(const LiveView&) = delete;

    /// After each pass: the state, the image if it is its turn. An order to stop goes to
    /// `interruption`.
    void pass_done(const RenderTotals& totals, ErrorWatch& error, Interruption& interruption);
    /// Between two passes: stays there while the render is paused, until it goes on or is
    /// interrupted.
    void wait_while_paused(const RenderTotals& totals, ErrorWatch& error,
                           Interruption& interruption);
    /// After the last pass, before files are written.
    void passes_over(const RenderTotals& totals, ErrorWatch& error);
    /// All is written, or not; watchers get a moment to see it.
    void ended(const RenderTotals& totals, bool written);

    double paused_seconds() const;

  private:
    class Show;
    std::unique_ptr<Show> show_;  ///< null: nothing is served
};

}  // namespace lxs
