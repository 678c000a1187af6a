// The host's media in the engine's terms.
#pragma once

#include <memory>

#include "aips/adapter/media.h"
#include "lxs/sdk/scene.h"

namespace aips::shim {

/// `scene` outlives it.
std::unique_ptr<Media> make_media_shim(const lxs::Scene& scene);

}  // namespace aips::shim
