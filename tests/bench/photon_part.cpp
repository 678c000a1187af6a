// The override that makes a photon method write what photons carry as layers of their own.
#include "photon_part.h"

#include <algorithm>

namespace bench {

void add_photon_part(const std::string& integrator, const lxs::PluginLibrary& plugins,
                     std::vector<std::string>& overrides) {
    const lxs::LoadedIntegrator* loaded = plugins.find(integrator);
    if (loaded == nullptr) return;
    const auto declared = loaded->plugin->parameters;
    const bool known = std::any_of(declared.begin(), declared.end(), [](const auto& parameter) {
        return parameter.name == "debuglayers";
    });
    if (known) overrides.push_back(integrator + ".debuglayers=true");
}

}  // namespace bench
