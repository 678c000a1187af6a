// The dynamic loader knows which file this code came from.
#include "lxs/modules/module_file.h"

#include <dlfcn.h>
#include <link.h>

#include <boost/dll/runtime_symbol_info.hpp>
#include <system_error>

namespace lxs {
namespace {

namespace fs = std::filesystem;

/// The shared object that this code is part of; empty if that is the program itself.
fs::path own_shared_object() {
    Dl_info info{};
    void* entry = nullptr;
    const auto* const here = reinterpret_cast<const void*>(&own_shared_object);
    if (::dladdr1(here, &info, &entry, RTLD_DL_LINKMAP) == 0 || entry == nullptr) return {};
    const char* const name = static_cast<const link_map*>(entry)->l_name;
    std::error_code unknown;
    return name == nullptr || *name == '\0' ? fs::path() : fs::canonical(name, unknown);
}

}  // namespace

std::vector<fs::path> program_folders() {
    const fs::path shared = own_shared_object();
    if (shared.empty()) return {boost::dll::program_location().parent_path()};
    const fs::path folder = shared.parent_path();
    return {folder / LXS_INSTALLED_BIN_FROM_PYTHON, folder / LXS_BUILT_BIN_FROM_PYTHON};
}

fs::path beside_program(std::initializer_list<fs::path> paths) {
    for (const fs::path& folder : program_folders()) {
        for (const fs::path& path : paths) {
            fs::path found = (folder / path).lexically_normal();
            std::error_code unknown;
            if (fs::exists(found, unknown)) return found;
        }
    }
    return {};
}

}  // namespace lxs
