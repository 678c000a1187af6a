// Loads the module with MPI.
#include "lxs/mpi/process_group.h"

#include <filesystem>

#include "lxs/modules/load_module.h"
#include "lxs/modules/module_file.h"

namespace lxs {
namespace {

std::filesystem::path mpi_module() {
    return beside_program({LXS_INSTALLED_MPI, LXS_BUILT_MPI});
}

}  // namespace

bool has_process_group() {
    return !mpi_module().empty();
}

ProcessGroup& process_group() {
    static boost::dll::shared_library module;
    const std::filesystem::path file = mpi_module();
    try {
        // Open MPI loads parts of its own, which look for its symbols among those of all.
        load_module(module, file,
                    boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_global);
        return *module_function<ProcessGroup*()>(module, "lxs_process_group")();
    } catch (const std::exception& cause) {
        throw ProcessGroupFailure("MPI can't be used: '" + file.string() +
                                  "' can't be loaded: " + cause.what());
    }
}

}  // namespace lxs
