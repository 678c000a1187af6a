// lxsrender: renders a LuxRender scene file.
#include <cstdio>

#include "lxs/host/command_line.h"
#include "lxs/host/console_log.h"
#include "lxs/host/process_faults.h"
#include "lxs/host/rank_job.h"
#include "lxs/host/render_command.h"
#include "lxs/merge/render_parts.h"

namespace lxs {
namespace {

ExitCode run(CommandLine& command, RankJob* job) {
    command.helps = job && job->helps();
    ConsoleLog log(command.helps ? Verbosity::Quiet : command.verbosity);
    return carry_out(command, log, job);
}

/// Renders passes of its own; the first process then merges those of all.
ExitCode run_part(const CommandLine& command, RankJob& job) {
    if (command.passes && *command.passes < job.count()) {
        ConsoleLog log(command.verbosity);
        log.error("--mpi-split passes: there must be a pass for each process");
        return job.end(ExitCode::Usage);
    }
    const CommandLine part = part_of_render(command, job.rank(), job.count());
    ExitCode code = ExitCode::Success;
    {
        ConsoleLog log(part.verbosity);
        code = carry_out(part, log);
    }
    const bool merges = !job.helps() && job.count() > 1;
    code = job.end(code);
    return merges && code == ExitCode::Success ? merge_parts(command, job.count()) : code;
}

ExitCode run(int argc, char** argv, RankJob* job) {
    CommandLine command;
    ExitCode code = ExitCode::Success;
    if (const auto done = parse_command_line(argc, argv, command)) {
        code = *done;
    } else if (job && job->count() > 1 && command.mpi_split == MpiSplit::Passes) {
        return run_part(command, *job);
    } else {
        code = run(command, job);
    }
    return job ? job->end(code) : code;
}

}  // namespace
}  // namespace lxs

int main(int argc, char** argv) {
    lxs::receive_faults_as_errors();
    try {
        const auto job = lxs::join_rank_job(argc, argv);
        return static_cast<int>(lxs::run(argc, argv, job.get()));
    } catch (const lxs::ProcessGroupFailure& failure) {
        std::fprintf(stderr, "error: %s\n", failure.what());
        return static_cast<int>(lxs::ExitCode::PluginFailure);
    }
}
