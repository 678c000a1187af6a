// Loads the module with MPI.
#include "lxs/mpi/process_group.h"

#include <boost/dll/runtime_symbol_info.hpp>
#include <boost/dll/shared_library.hpp>
#include <filesystem>
#include <system_error>

namespace lxs {
namespace {

namespace fs = std::filesystem;

fs::path module_file() {
    const fs::path bin = boost::dll::program_location().parent_path();
    for (const char* folder : {LXS_INSTALLED_MPI, LXS_BUILT_MPI}) {
        fs::path file = bin / folder / LXS_MPI_MODULE;
        std::error_code unknown;
        if (fs::exists(file, unknown)) return file;
    }
    return {};
}

}  // namespace

bool has_process_group() {
    return !module_file().empty();
}

ProcessGroup& process_group() {
    static boost::dll::shared_library module;
    const fs::path file = module_file();
    try {
        // Open MPI loads parts of its own, which look for its symbols among those of all.
        module.load(file, boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_global);
        return *module.get<ProcessGroup*()>("lxs_process_group")();
    } catch (const std::exception& cause) {
        throw ProcessGroupFailure("MPI can't be used: '" + file.string() +
                                  "' can't be loaded: " + cause.what());
    }
}

}  // namespace lxs
