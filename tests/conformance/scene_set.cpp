// The scenes that are compared: NAME.lxs beside NAME.exr in one folder, and how close they must be.
#include "scene_set.h"

#include <algorithm>
#include <stdexcept>

namespace conformance {
namespace fs = std::filesystem;

Spread limit_for(const std::string& name) {
    constexpr Spread kUsual{0.02, 0.06};
    constexpr Spread kFireflies{0.02, 0.10};
    return name.starts_with("material-roughglass") ? kFireflies : kUsual;
}

std::vector<Scene> scenes_in(const fs::path& folder, const std::vector<std::string>& names) {
    std::vector<Scene> scenes;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const fs::path& file = entry.path();
        const std::string name = file.stem().string();
        const fs::path reference = folder / (name + ".exr");
        if (file.extension() != ".lxs" || !fs::exists(reference)) continue;
        if (!names.empty() && std::find(names.begin(), names.end(), name) == names.end()) continue;
        scenes.push_back({name, file, reference, limit_for(name)});
    }
    std::sort(scenes.begin(), scenes.end(),
              [](const Scene& a, const Scene& b) { return a.name < b.name; });
    for (const std::string& name : names) {
        if (std::none_of(scenes.begin(), scenes.end(),
                         [&](const Scene& s) { return s.name == name; })) {
            throw std::runtime_error("no scene \"" + name + "\" with an image in " +
                                     folder.string());
        }
    }
    return scenes;
}

}  // namespace conformance
