// A module whose entry function throws.
#include <stdexcept>

#include "lxs/sdk/plugin.h"

extern "C" __attribute__((visibility("default"))) const lxs::PluginModule* lxs_plugin_module() {
    throw std::runtime_error("the licence has run out");
}
