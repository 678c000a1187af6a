// Renders small scenes with `path`, for tests.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lxs/scene/contents.h"
#include "lxs/scene/registry.h"
#include "lxs/sdk/integrator.h"
#include "path/path_settings.h"

namespace lxs::test {

/// Mean radiance over an image and its standard error, estimated from batches of passes.
struct MeanRadiance {
    Rgb mean{0.0f};
    Rgb standard_error{0.0f};
};

/// Options for a square camera at (0, 0, height) that looks down with a narrow field of view: all
/// pixels see nearly the same point.
std::string camera_above(double height, double field_of_view = 1);

/// A horizontal square around the z axis as a Shape; its front is up, or down with `down`.
std::string square(double z, double half_side, bool down = false);

/// Renders `text` (options, WorldBegin ... WorldEnd; the film is given by the test) at 8 x 8 pixels
/// for `passes` passes in batches.
MeanRadiance render_mean(const std::string& text, const PathSettings& settings = {},
                         int passes = 64, std::uint64_t seed = 1);

/// The whole image, row by row.
std::vector<Rgb> render_image(const std::string& text, const PathSettings& settings, int passes,
                              Statistics* statistics = nullptr, std::uint64_t seed = 1);

/// The whole image of a scene that is read otherwise, whose lights' files lie in `folder`; warnings
/// do not fail the test.
std::vector<Rgb> render_image(
    const std::function<SceneContents(const Registry&, Diagnostics&)>& read,
    const PathSettings& settings, int passes, const std::string& folder);

/// |a - b| in units of their joint standard error, the largest over the channels.
double z_score(const MeanRadiance& a, const MeanRadiance& b);

}  // namespace lxs::test
