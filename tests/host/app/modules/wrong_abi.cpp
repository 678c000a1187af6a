// A module that claims another version of the plugin SDK.
#include "lxs/sdk/plugin.h"

extern "C" __attribute__((visibility("default"))) const lxs::PluginModule* lxs_plugin_module() {
    static const lxs::PluginModule module{lxs::kAbiVersion + 41, "wrong-abi", {}};
    return &module;
}
