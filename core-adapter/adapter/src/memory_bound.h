// How much memory the engine can take, from the parameters alone.
#pragma once

#include <cstddef>

#include "aips/adapter/scene.h"
#include "needs.h"

namespace aips {

/// Upper bound in bytes of what the engine holds at any time of a render that needs no more than
/// `needs`. `pixels`: of the film.
std::size_t memory_bound(const Scene& scene, const Needs& needs, std::uint32_t eye_paths,
                         std::size_t pixels);

}  // namespace aips
