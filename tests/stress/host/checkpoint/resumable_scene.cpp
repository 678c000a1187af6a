// Small renders of every kind whose state a checkpoint has to hold.
#include "resumable_scene.h"

#include <filesystem>
#include <string_view>

namespace stress {

const std::vector<ResumableRender>& resumable_renders() {
    using Options = std::vector<std::string>;
    const auto photons = [](const std::string& plugin, Options more = {}) {
        more.insert(more.end(), {"--integrator", plugin, "--set", plugin + ".photonperpass=6000"});
        return more;
    };
    static const std::vector<ResumableRender> renders = {
        {"path", "glass-ball", {"--integrator", "path"}, 10},
        // Files of megabytes, which take a while to write.
        {"path_large", "glass-ball", {"--integrator", "path", "--width", "320"}, 6},
        {"path_by_wavelengths", "prism", {"--integrator", "path"}, 10},
        {"metropolis", "glass-ball", {"--integrator", "path", "--sampler", "metropolis"}, 10},
        {"unguided", "glass-ball", photons("aips", {"--set", "aips.guide=none"}), 8},
        {"adaptive_guide", "glass-ball", photons("aips", {"--set", "aips.debuglayers=true"}), 8},
        {"adaptive_guide_by_wavelengths", "prism", photons("aips"), 8},
        {"paper_guide", "glass-ball", photons("aips", {"--set", "aips.guide=paper"}), 8},
        {"adaptive_radius", "glass-ball", photons("aips", {"--set", "aips.radius=adaptive"}), 8},
        {"sppm_chains", "glass-ball", photons("sppm", {"--set", "sppm.photonsampler=amc"}), 8},
        {"ppm", "glass-ball", photons("ppm"), 8},
        {"photon_map", "glass-ball", photons("exphotonmap"), 8},
    };
    return renders;
}

std::vector<ResumableRender> rich_renders() {
    std::vector<ResumableRender> rich = resumable_renders();
    std::erase_if(rich, [](const ResumableRender& render) {
        const std::string_view name = render.name;
        return name != "metropolis" && name != "adaptive_guide" && name != "adaptive_radius" &&
               name != "sppm_chains" && name != "ppm";
    });
    return rich;
}

std::vector<std::string> put_scene(const ResumableRender& render, const render::Folder& folder) {
    const auto scene = render::small_scene(render.scene, folder, 48, 36);
    // The image is written between passes, too.
    const auto edited = render::edited_scene(
        scene, folder,
        {{"\"integer haltspp\"", "\"integer writeinterval\" [1] \"integer haltspp\""}});
    std::filesystem::rename(edited, folder / "scene.lxs");
    std::vector<std::string> options = {"scene.lxs"};
    options.insert(options.end(), render.options.begin(), render.options.end());
    return options;
}

}  // namespace stress
