// lxsrender: renders a LuxRender scene file.
#include "lxs/host/command_line.h"
#include "lxs/host/console_log.h"
#include "lxs/host/process_faults.h"
#include "lxs/host/render_command.h"

int main(int argc, char** argv) {
    lxs::receive_faults_as_errors();
    lxs::CommandLine command;
    if (const auto done = lxs::parse_command_line(argc, argv, command)) {
        return static_cast<int>(*done);
    }
    lxs::ConsoleLog log(command.verbosity);
    return static_cast<int>(lxs::carry_out(command, log));
}
