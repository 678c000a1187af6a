// Processes that render one image together, as the ranks of an MPI job do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace aips {

/// What all ranks said, one after the other in the order of ranks.
struct RankMessages {
    std::shared_ptr<const std::byte[]> bytes;
    std::vector<std::size_t> begins;  ///< [rank] of its message in `bytes`, and the end of the last

    std::span<const std::byte> of(std::uint32_t rank) const {
        return {bytes.get() + begins[rank], begins[rank + 1] - begins[rank]};
    }
};

/// Each rank has the same scene, settings and seed, and renders the same passes. Work that takes
/// paths or visible points one by one is done by one rank for each part and told to the others, so
/// that after it all have the same bits, which are those that one process alone would have. All
/// else each does for itself.
class Ranks {
  public:
    virtual ~Ranks() = default;
    virtual std::uint32_t rank() const = 0;   ///< of this process, below count()
    virtual std::uint32_t count() const = 0;  ///< >= 1
    /// Tells `own` to all ranks and returns what each told. All ranks call it equally often, one
    /// call at a time; it returns when all have. Throws std::runtime_error where others are gone.
    virtual RankMessages exchange(std::span<const std::byte> own) = 0;
};

}  // namespace aips
