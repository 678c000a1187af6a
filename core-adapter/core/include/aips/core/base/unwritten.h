// Vectors whose new elements are left unwritten: room is made by one thread, and what it holds is
// written by all.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace aips {

/// Leaves elements that are made without arguments as the memory was.
template <class T>
requires std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>
struct UnwrittenAllocator : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = UnwrittenAllocator<U>;
    };

    template <class U>
    void construct(U* /*place*/) noexcept {}
    template <class U, class... Arguments>
    void construct(U* place, Arguments&&... arguments) {
        std::construct_at(place, std::forward<Arguments>(arguments)...);
    }
};

/// resize() neither writes new elements nor touches their memory. Of aggregates, which begin to
/// live where memory is taken for them ([intro.object]).
template <class T>
using UnwrittenVector = std::vector<T, UnwrittenAllocator<T>>;

}  // namespace aips
