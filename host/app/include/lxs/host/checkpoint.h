// Checkpoints of a render: where they go, when they are written, and how a render goes on from one.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lxs/host/command_line.h"
#include "lxs/host/console_log.h"
#include "lxs/host/progress.h"
#include "lxs/host/render_session.h"

namespace lxs {

/// Throws CheckpointFailure if a file is there already that would be replaced, as a render replaces
/// only the checkpoint that it has gone on from; OutputFailure if none can be written there.
void check_checkpoint_place(const CommandLine& command, ConsoleLog& log);

/// A checkpoint of this very render, whole but not restored yet; its bytes.
using FoundCheckpoint = std::vector<std::byte>;

/// The checkpoint that `--resume` goes on from; none, and a message, if there is no such file.
/// Throws CheckpointFailure if it is damaged, of another version or of another render.
std::optional<FoundCheckpoint> find_checkpoint(const CommandLine& command,
                                               const RenderSession& session, ConsoleLog& log);

/// Restores film and integrator, which must be prepared; gives the totals at the checkpoint. Throws
/// CheckpointFailure.
RenderTotals restore(FoundCheckpoint found, const CommandLine& command, RenderSession& session,
                     ConsoleLog& log);

/// Writes a checkpoint whenever the interval has gone by. One that can't be written is a warning:
/// the render goes on, the older one stays.
class CheckpointSchedule {
  public:
    /// `totals` are those that the render begins with. Throws CheckpointFailure if the integrator
    /// has no state to save.
    CheckpointSchedule(const CommandLine& command, RenderSession& session, ConsoleLog& log,
                       const RenderTotals& totals);

    void pass_done(const RenderTotals& totals);
    /// Writes the last one, unless it is there already.
    void finish(const RenderTotals& totals);

  private:
    void write(const RenderTotals& totals);

    const CommandLine& command_;
    RenderSession& session_;
    ConsoleLog& log_;
    std::uint64_t saved_passes_;
    double saved_seconds_;
};

}  // namespace lxs
