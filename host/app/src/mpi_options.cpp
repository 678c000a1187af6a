// Options of renders by several processes.
#include "mpi_options.h"

#include <map>
#include <string>

#include "lxs/host/output_files.h"
#include "lxs/mpi/process_group.h"

namespace lxs {

void add_mpi_options(CLI::App& app, CommandLine& command) {
    const char* const processes = "Several processes";
    app.add_flag("--mpi", command.mpi,
                 "Render together with the other processes that mpirun has started: they share the "
                 "work of each pass, and the image has the same bits with any number of them.")
        ->group(processes)
        ->disable_flag_override()  // the processes meet before options are read
        ->excludes(app.get_option("--explain"));
    app.add_option("--mpi-split", command.mpi_split,
                   "What the processes share: photons, and the eye paths of each pass with them; "
                   "or passes, each process with a seed of its own, which are merged (default: "
                   "photons).")
        ->group(processes)
        ->type_name("photons|passes")
        ->transform(
            CLI::CheckedTransformer(std::map<std::string, MpiSplit>{{"photons", MpiSplit::Photons},
                                                                    {"passes", MpiSplit::Passes}},
                                    CLI::ignore_case)
                .description(""))
        ->needs(app.get_option("--mpi"));
}

void check_mpi(const CommandLine& command) {
    if (!command.mpi) return;
    if (!has_process_group())
        throw CLI::ValidationError("--mpi",
                                   "this lxsrender has no MPI: build it where Open MPI is "
                                   "installed, with -DAIPS_MPI=ON");
    if (command.scene == "-")
        throw CLI::ValidationError("--mpi",
                                   "the scene must be a file, which all processes can read: of "
                                   "standard input only the first has any");
    if (command.mpi_split != MpiSplit::Passes) return;
    if (!command.output || !has_suffix(*command.output, ".exr"))
        throw CLI::ValidationError("--mpi-split",
                                   "passes are merged into an EXR file: give its name by -o");
}

}  // namespace lxs
