// A sampler without pattern: uniform film and lens positions.
#pragma once

#include "aips/adapter/camera.h"
#include "aips/core/sampling/random.h"

namespace aips {

/// Positions within each pixel, different for every sample number; images up to 65536 pixels wide.
class UniformSampler final : public Sampler {
  public:
    explicit UniformSampler(std::uint64_t seed) : seed_(seed) {}
    CameraSample camera_sample(std::uint64_t number, std::uint32_t x,
                               std::uint32_t y) const override {
        RandomStream random(seed_, number, y * 65536u + x, RandomDomain::Film);
        const Vec2 u = random.next2();
        return {{float(x) + u.x, float(y) + u.y}, random.next2()};
    }

  private:
    std::uint64_t seed_;
};

}  // namespace aips
