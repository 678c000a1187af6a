// How much memory the engine can take, from the parameters alone.
#pragma once

#include <cstddef>

#include "aips/adapter/scene.h"
#include "aips/adapter/settings.h"

namespace aips {

/// Upper bound in bytes of what the engine holds at any time of a render.
/// `pixels`: of the film.
std::size_t memory_bound(const Scene& scene, const Settings& settings, std::uint32_t eye_paths,
                         std::size_t pixels);

}  // namespace aips
