// What a render leaves behind: its images and its statistics, also when it ended before its time.
#pragma once

#include "lxs/host/console_log.h"
#include "lxs/host/exit_code.h"
#include "lxs/host/progress.h"
#include "lxs/host/render_session.h"

namespace lxs {

/// What goes into the image's header. No times: the same scene, settings and seed give the same
/// file, bit for bit.
ImageMetadata image_metadata(const CommandLine& command, const RenderSession& session,
                             const RenderTotals& totals);

/// Writes images and statistics of a render that ended as it should, or was interrupted. What can't
/// be written is reported and, if any place takes it, saved there. Gives Success, Interrupted,
/// OutputFailure or PluginFailure (the integrator failed to give its figures).
ExitCode write_final_outputs(const CommandLine& command, RenderSession& session,
                             const RenderTotals& totals, bool interrupted, ConsoleLog& log);

/// For a render that ends with an exception after `totals.passes` passes: writes what these gave,
/// and says so. The scene and the integrator are given up first, as their memory may be what is
/// missing. Does not throw.
void save_finished_passes(const CommandLine& command, RenderSession& session,
                          const RenderTotals& totals, ConsoleLog& log);

}  // namespace lxs
