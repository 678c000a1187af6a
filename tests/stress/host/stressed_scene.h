// Small scenes for lxsrender with one thing wrong in them, and all that a render of one says.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "rendered_image.h"

namespace stress {

/// A way to render: arguments of lxsrender after the scene.
struct RenderWay {
    std::string name, arguments;
};

/// aips with each guide and in each mode, sppm, path, and path under Metropolis sampling.
const std::vector<RenderWay>& all_ways();
/// One each of aips, sppm, path and Metropolis.
const std::vector<RenderWay>& main_ways();
/// The first of these with --strict, which refuses what is otherwise left out.
RenderWay strict_way();

struct Outcome {
    int exit_code = 0;
    std::string messages;  ///< standard error
    render::Image image;   ///< empty without one
    nlohmann::json statistics;

    /// Pixels whose R, G or B is NaN, infinite or negative.
    std::size_t bad_pixels() const;
    double mean() const;  ///< luminance over the image
    /// Count of one origin of the JSON's "refused", 0 if absent.
    std::uint64_t refused(const std::string& kind, const std::string& origin) const;
    /// Names of all origins of a kind.
    std::vector<std::string> origins(const std::string& kind) const;
};

/// Camera, film of 16 x 12 pixels; then `world`, in a room of [-2, 2]^3 open to the camera, lit by
/// a lamp under its ceiling unless `lit` is false. The walls' material is named "wall".
std::string room(const std::string& world, bool lit = true);

/// A quad as a Shape, from its four corners' coordinates; its front is by the right hand.
std::string quad(const std::string& corners);

/// Writes `scene` beside the files that are in `folder` and renders it.
Outcome render_scene(const std::string& scene, const RenderWay& way, const render::Folder& folder,
                     int passes = 4);

}  // namespace stress
