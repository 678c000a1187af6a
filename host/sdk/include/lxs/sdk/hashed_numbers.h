// Random numbers that follow from what they are for: who estimates a value by a random walk, and is
// given no numbers for it, must give the same value whenever it is asked the same question.
// Source: Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators"
// (SplitMix64).
#pragma once

#include <bit>
#include <cstdint>

#include "lxs/sdk/types.h"

namespace lxs {

class HashedNumbers {
  public:
    /// Continues the stream's address by a vector's bits.
    HashedNumbers& about(const Vec3& v) { return about(v.x).about(v.y).about(v.z); }
    HashedNumbers& about(float value) {
        state_ = mixed(state_ ^ std::bit_cast<std::uint32_t>(value));
        return *this;
    }
    /// The next number in [0, 1).
    float next() {
        state_ += kStep;
        return static_cast<float>(mixed(state_) >> 40) * 0x1p-24f;
    }
    Vec2 pair() {
        const float x = next();
        return {x, next()};
    }

  private:
    static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15;

    static std::uint64_t mixed(std::uint64_t z) {
        z += kStep;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }

    std::uint64_t state_ = 0;
};

}  // namespace lxs
