// lxsrender: renders a LuxRender scene file.
#include <cstdio>

#include "lxs/host/command_line.h"
#include "lxs/host/console_log.h"
#include "lxs/host/process_faults.h"
#include "lxs/host/rank_job.h"
#include "lxs/host/render_command.h"

namespace lxs {
namespace {

ExitCode run(int argc, char** argv, RankJob* job) {
    CommandLine command;
    if (const auto done = parse_command_line(argc, argv, command)) return *done;
    command.helps = job && job->helps();
    ConsoleLog log(command.helps ? Verbosity::Quiet : command.verbosity);
    return carry_out(command, log, job);
}

}  // namespace
}  // namespace lxs

int main(int argc, char** argv) {
    lxs::receive_faults_as_errors();
    try {
        const auto job = lxs::join_rank_job(argc, argv);
        const lxs::ExitCode code = lxs::run(argc, argv, job.get());
        return static_cast<int>(job ? job->end(code) : code);
    } catch (const lxs::ProcessGroupFailure& failure) {
        std::fprintf(stderr, "error: %s\n", failure.what());
        return static_cast<int>(lxs::ExitCode::PluginFailure);
    }
}
