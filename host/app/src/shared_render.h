// A render that ranks share: what each does before the passes, and the passes of those that help.
#pragma once

#include "lxs/host/console_log.h"
#include "lxs/host/render_session.h"

namespace lxs {

/// Throws SceneFailure if the integrator can't share its passes.
void join_job(RenderSession& session, const CommandLine& command, RankJob& job, ConsoleLog& log);

/// Before the first pass, of which `passes` were done before: throws RankFailure unless all ranks
/// have the same render to begin with.
void agree_on_begin(const RenderSession& session, std::uint64_t passes);

/// The passes of a rank that helps, until the first has no more.
ExitCode help_render(RenderSession& session, std::uint64_t passes);

}  // namespace lxs
