// Puts a Bsdf into the memory that Material::scatter is handed.
#pragma once

#include <memory_resource>
#include <new>
#include <type_traits>
#include <utility>

#include "lxs/sdk/bsdf.h"

namespace lxs::shading {

/// Builds a B in `memory`; nothing ever destroys it.
template <class B, class... Arguments>
const B* place_bsdf(std::pmr::memory_resource& memory, Arguments&&... arguments) {
    static_assert(std::is_trivially_destructible_v<B>, "Bsdf memory is dropped, not destroyed");
    return ::new (memory.allocate(sizeof(B), alignof(B))) B(std::forward<Arguments>(arguments)...);
}

/// Most memory that place_bsdf<B> takes from a resource, alignment included.
template <class B>
inline constexpr std::size_t kBsdfBytes = sizeof(B) + alignof(B) - 1;

}  // namespace lxs::shading
