// How much memory the engine can take, from the parameters and the number of threads alone.
#pragma once

#include <cstddef>

#include "aips/adapter/scene.h"
#include "plan/needs.h"

namespace aips {

/// Upper bound in bytes of what an eye pass leaves, and what is learned from its shadow rays, at
/// any time of a render.
std::size_t eye_memory_bound(const Scene& scene, const Settings& settings, std::uint32_t eye_paths);

/// The same of all that photons add, in a render that needs no more than `needs`. `pixels`: of the
/// film.
std::size_t photon_memory_bound(const Scene& scene, const Needs& needs, std::uint32_t eye_paths,
                                std::size_t pixels);

}  // namespace aips
