// Processes that render one image together, as the ranks of an MPI job do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace lxs {

/// What all ranks said, one after the other in the order of ranks.
struct RankMessages {
    std::shared_ptr<const std::byte[]> bytes;
    std::vector<std::size_t> begins;  ///< [rank] of its message in `bytes`, and the end of the last

    std::span<const std::byte> of(std::uint32_t rank) const {
        return {bytes.get() + begins[rank], begins[rank + 1] - begins[rank]};
    }
};

/// Each rank has the same scene, settings and seed, and renders the same passes, one after the
/// other. The film of the first is the image; others drop what they are given.
class Ranks {
  public:
    virtual ~Ranks() = default;
    virtual std::uint32_t rank() const = 0;   ///< of this process, below count()
    virtual std::uint32_t count() const = 0;  ///< >= 1
    /// Tells `own` to all ranks and returns what each told. All ranks call it equally often, one
    /// call at a time; it returns when all have. Throws where one of them has failed.
    virtual RankMessages exchange(std::span<const std::byte> own) = 0;
};

}  // namespace lxs
