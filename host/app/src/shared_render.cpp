// A render that ranks share.
#include "shared_render.h"

#include <fmt/format.h>

#include <span>

#include "lxs/host/counted.h"
#include "lxs/host/failure.h"
#include "silent_film.h"

namespace lxs {

void join_job(RenderSession& session, const CommandLine& command, RankJob& job, ConsoleLog& log) {
    if (job.count() > 1 && !session.integrator->shares_passes()) {
        throw SceneFailure(
            fmt::format("{}: \"{}\" can't share its passes with other processes: --mpi is for "
                        "integrators that do, such as \"aips\"",
                        command.scene, session.integrator_name));
    }
    session.job = &job;
    if (job.helps()) session.no_film = std::make_unique<SilentFilm>(*session.film);
    log.info(counted(job.count(), "process renders", "processes render") + " each pass together");
}

void agree_on_begin(const RenderSession& session, std::uint64_t passes) {
    session.job->agree(session.fingerprint.bytes(), "has another scene, or other settings,");
    session.job->agree(std::as_bytes(std::span(&passes, 1)), "begins with another pass");
}

ExitCode help_render(RenderSession& session, std::uint64_t passes) {
    for (; session.job->another_pass(); ++passes)
        render_pass(session, passes);
    return ExitCode::Success;
}

}  // namespace lxs
