// Builds the traceable scene: geometry in Embree, lights, media.
#pragma once

#include <memory>

#include "lxs/lights/lights.h"
#include "lxs/scene/contents.h"
#include "lxs/sdk/scene.h"

namespace lxs {

/// Takes over the contents and builds acceleration structures and lights. The build is
/// deterministic: the same contents give the same hits, ties included, for any number of threads.
std::unique_ptr<Scene> make_trace_scene(SceneContents contents, const AssetResolver& resolve,
                                        Diagnostics& diagnostics);

}  // namespace lxs
