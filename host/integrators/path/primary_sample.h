// The numbers that make an eye path: a point in primary sample space.
#pragma once

#include <array>
#include <cstddef>

#include "lxs/sdk/state_archive.h"
#include "lxs/sdk/types.h"

namespace lxs {

/// Numbers in [0,1), one dimension after the other; a path is a pure function of them. They come
/// in blocks, so that whoever makes them is asked only once in four dimensions.
class PrimarySample {
  public:
    float next() {
        if (used_ == block_.size()) {
            next_block(block_);
            used_ = 0;
        }
        return block_[used_++];
    }
    Vec2 next_2d() {
        const float first = next();
        return {first, next()};
    }

  protected:
    using Block = std::array<float, 4>;

    PrimarySample() = default;
    PrimarySample(const PrimarySample&) = default;
    PrimarySample& operator=(const PrimarySample&) = default;
    ~PrimarySample() = default;
    /// How far the present block has been read.
    void block_state(StateArchive& archive) {
        archive.fixed(std::span(block_));
        std::uint64_t used = used_;
        archive.value(used);
        if (used > block_.size()) throw StateError("a sample has read more than there is of it");
        used_ = used;
    }
    /// The next number asked for starts a new block.
    void drop_block() { used_ = block_.size(); }

  private:
    /// Gives the next four dimensions.
    virtual void next_block(Block& block) = 0;

    Block block_{};
    std::size_t used_ = std::tuple_size_v<Block>;
};

}  // namespace lxs
