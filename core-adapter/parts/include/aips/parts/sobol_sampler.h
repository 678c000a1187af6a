// A sampler whose samples of a pixel are spread evenly: less noise than positions by chance.
#pragma once

#include "aips/adapter/camera.h"
#include "aips/core/sampling/low_discrepancy.h"

namespace aips {

/// An Owen-scrambled Sobol' sequence for each pixel, for hosts whose own samplers cannot be asked
/// for sample n of a pixel. Every aligned block of 4^k numbers has one sample in each of the 4^k
/// squares of the pixel. Takes dimensions 0 to 3.
class SobolSampler final : public Sampler {
  public:
    explicit SobolSampler(std::uint64_t seed)
        : seed_(hash_bits(static_cast<std::uint32_t>(seed ^ seed >> 32))) {}
    CameraSample camera_sample(std::uint64_t number, std::uint32_t x,
                               std::uint32_t y) const override {
        const std::uint32_t of_pixel = hash_bits(x + hash_bits(y + seed_));
        const auto u = [&](unsigned dimension) { return sobol_owen(number, dimension, of_pixel); };
        return {{float(x) + u(0), float(y) + u(1)}, {u(2), u(3)}};
    }

  private:
    std::uint32_t seed_;
};

}  // namespace aips
