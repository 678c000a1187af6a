// The image so far, written while a render goes on.
#pragma once

#include <optional>
#include <vector>

#include "lxs/host/budget.h"
#include "lxs/host/command_line.h"
#include "lxs/host/console_log.h"
#include "lxs/host/display_server.h"
#include "lxs/host/progress.h"
#include "lxs/host/render_session.h"
#include "lxs/host/write_schedule.h"

namespace lxs {

/// Writes EXR and PNG between passes, and shows the image in a viewer if one is named, each by a
/// schedule of its own. What can't be written is a warning, and the file of an earlier time stays:
/// the next turn, or the end, tries again.
class Snapshots {
  public:
    /// `--write-every` for both; else the film's writeinterval, for the PNG also its
    /// displayinterval.
    Snapshots(const CommandLine& command, RenderSession& session, const Budget& budget,
              ConsoleLog& log);

    /// Between two passes: writes what is due. Its time goes to the session's "write".
    void between_passes(const RenderTotals& totals);
    /// After the last: the viewer gets the finished image; files are written elsewhere.
    void finish(const RenderTotals& totals);

  private:
    void write_exr(const RenderTotals& totals);
    void write_png(const RenderTotals& totals);
    void show(const RenderTotals& totals);
    /// The denoised image for the files; empty if they have none so far.
    std::vector<Rgb> denoised() const;
    void say_where();

    const CommandLine& command_;
    RenderSession& session_;
    const Budget& budget_;
    ConsoleLog& log_;
    WriteSchedule exr_, png_, viewer_;
    std::optional<DisplayServer> display_;
    bool said_where_ = false;
    bool said_no_viewer_ = false;
};

}  // namespace lxs
