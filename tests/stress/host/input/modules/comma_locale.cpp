// A module that sets the process's locale to the environment's, as libraries of other kinds do.
#include <clocale>
#include <locale>

#include "lxs/sdk/plugin.h"

extern "C" __attribute__((visibility("default"))) const lxs::PluginModule* lxs_plugin_module() {
    std::setlocale(LC_ALL, "");
    std::locale::global(std::locale(""));
    static const lxs::PluginModule module{lxs::kAbiVersion, "comma-locale", {}};
    return &module;
}
