// What a saved state belongs to: it can be restored into the same render alone.
#pragma once

#include <cstdint>

#include "aips/adapter/engine.h"
#include "aips/core/base/state_archive.h"

namespace aips {

/// Saves what tells a render with `settings` of `eye_paths` a pass from others, or throws
/// StateError if that was another one. The scene's content is not looked at: that is for the host.
void state_of_identity(StateArchive& archive, const Host& host, const Settings& settings,
                       std::uint32_t eye_paths);

/// Saves which version of the engine learned something, or throws StateError if that was another.
void state_of_version(StateArchive& archive);

}  // namespace aips
