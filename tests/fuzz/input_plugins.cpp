// Loads the plugins.
#include "input_plugins.h"

namespace fuzz {

const lxs::PluginLibrary& plugins() {
    static const auto library = [] {
        auto made = std::make_unique<lxs::PluginLibrary>();
        made->load_folder(AIPS_FUZZ_PLUGINS);
        return made;
    }();
    return *library;
}

}  // namespace fuzz
