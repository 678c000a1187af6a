// Random numbers of one eye path.
#pragma once

#include <Random123/philox.h>

#include <cstdint>

#include "path/primary_sample.h"

namespace lxs {

/// Keeps apart the numbers that different parts draw with the same seed.
enum class RandomDomain : std::uint32_t {
    Path = 0x70617468,
    MetropolisSeeds = 0x6d6c7462,
    MetropolisChain = 0x6d6c7463,
    LightsAhead = 0x6c616864,
};

/// Numbers in [0,1), a pure function of (domain, seed, pass, pixel, dimension): counter-based
/// Philox 4x32-10 (Salmon et al. 2011, "Parallel random numbers: as easy as 1, 2, 3"), four
/// dimensions a block. Markov chains put (mutation, chain) in the place of (pass, pixel).
class RandomStream final : public PrimarySample {
  public:
    RandomStream(std::uint64_t seed, std::uint64_t pass, std::uint32_t pixel,
                 RandomDomain domain = RandomDomain::Path)
        : key_{{static_cast<std::uint32_t>(seed),
                static_cast<std::uint32_t>(seed >> 32) ^ static_cast<std::uint32_t>(domain)}},
          counter_{{pixel, static_cast<std::uint32_t>(pass), static_cast<std::uint32_t>(pass >> 32),
                    0}} {}

    /// Where in the stream the next number is.
    void state(StateArchive& archive) {
        archive.fixed(std::span(key_.v));
        archive.fixed(std::span(counter_.v));
        block_state(archive);
    }

  private:
    void next_block(Block& block) override {
        const r123::Philox4x32::ctr_type bits = r123::Philox4x32()(counter_, key_);
        ++counter_[3];
        for (std::size_t i = 0; i < block.size(); ++i)
            block[i] = static_cast<float>(bits[i] >> 8) * 0x1p-24f;
    }

    r123::Philox4x32::key_type key_;
    r123::Philox4x32::ctr_type counter_;
};

}  // namespace lxs
