// Refuses settings that no memory of this machine could hold, before any of it is taken.
#pragma once

#include <cstddef>

namespace aips::shim {

/// Throws std::runtime_error if `bound_bytes`, the engine's own bound, is more than twice the
/// machine's memory. The bound allows for growth of stores by doubling: what is within twice the
/// memory may still fit.
void check_memory(std::size_t bound_bytes);

}  // namespace aips::shim
