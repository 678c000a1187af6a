// Random numbers of one camera path.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

#include "lxs/sdk/types.h"

namespace lxs {

/// Numbers in [0,1), a pure function of (seed, pass, pixel, dimension): counter-based Philox
/// 4x32-10 (Salmon et al. 2011, "Parallel random numbers: as easy as 1, 2, 3"), four dimensions a
/// block.
class RandomStream {
  public:
    RandomStream(std::uint64_t seed, std::uint64_t pass, std::uint32_t pixel)
        : key_{{static_cast<std::uint32_t>(seed),
                static_cast<std::uint32_t>(seed >> 32) ^ kDomain}},
          counter_{{pixel, static_cast<std::uint32_t>(pass), static_cast<std::uint32_t>(pass >> 32),
                    0}} {}

    float next() {
        if (used_ == block_.size()) {
            block_ = r123::Philox4x32()(counter_, key_);
            ++counter_[3];
            used_ = 0;
        }
        return static_cast<float>(block_[used_++] >> 8) * 0x1p-24f;
    }
    Vec2 next_2d() {
        const float first = next();
        return {first, next()};
    }

  private:
    /// Keeps these numbers apart from those that others draw with the same seed.
    static constexpr std::uint32_t kDomain = 0x70617468;

    r123::Philox4x32::key_type key_;
    r123::Philox4x32::ctr_type counter_;
    r123::Philox4x32::ctr_type block_{};
    std::size_t used_ = block_.size();
};

}  // namespace lxs
