// Small renders of every kind whose state a checkpoint has to hold.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "rendered_image.h"

namespace stress {

struct ResumableRender {
    const char* name;
    const char* scene;  ///< of scenes/
    std::vector<std::string> options;
    int passes;  ///< that make a render of it
};

inline std::ostream& operator<<(std::ostream& out, const ResumableRender& render) {
    return out << render.name;
}

/// Integrators, guides, photon samplers and modes; scenes that disperse and that have layers.
const std::vector<ResumableRender>& resumable_renders();

/// Those whose state has parts of its own beside film and counts, one of a kind.
std::vector<ResumableRender> rich_renders();

/// Puts the scene into `folder` as scene.lxs, and gives the options that render it; the
/// number of passes is not among them.
std::vector<std::string> put_scene(const ResumableRender& render, const render::Folder& folder);

}  // namespace stress
