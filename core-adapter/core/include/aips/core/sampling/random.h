// Random numbers that are addressed, not drawn in turn: by (seed, pass, index, domain).
// Source: Salmon et al. 2011, "Parallel random numbers: as easy as 1, 2, 3" (Philox4x32-10).
#pragma once

#include <Random123/philox.h>

#include <cstdint>

#include "aips/core/base/vector.h"

namespace aips {

/// What a stream of numbers is for; streams of different domains are independent. The numbers of
/// the domains are part of every render's bits.
enum class RandomDomain : std::uint8_t {
    Photon = 0,         ///< bounces of a photon path; index: the path
    Eye = 1,            ///< eye paths in media; index: the path
    Film = 2,           ///< film and lens positions of the ready sampler; index: the pixel
    Guide = 3,          ///< choices of a guide's training
    Time = 4,           ///< the moment of a pass; index 0
    Emitter = 5,        ///< emitter paths: lens; index: the path
    EmitterSearch = 6,  ///< searches for emitters; index: the search
    UniformPath = 7,    ///< independent paths of Markov chains; index: step * chains + chain
    MutatedPath = 8,    ///< mutations of Markov chains; index: step * chains + chain
    EyeSeeding = 9,     ///< walks from visible points to lights; index: the group of visible points
    BeamPhotons = 10,   ///< parts of eye paths in media; index: the eye path
    ChainStart = 11,    ///< which visible paths chains start from; index: the choice in the pass
    Edge = 12,          ///< places of gather discs; index: the eye path
    PhotonTurn = 13,    ///< which pass of several shoots photons; index: of these several
    LightsAhead = 14,   ///< eye paths before the first pass; index: the path
    Occlusion = 15      ///< photons that a visible point asks for; index: the eye path
};

/// The top 24 bits as a number in [0, 1); never 1, all 2^24 values equally likely.
constexpr float to_unit_float(std::uint32_t bits) {
    return float(bits >> 8) * 0x1p-24f;
}

/// One addressed sequence of independent uniform numbers, at most 2^26 of them. Construction costs
/// next to nothing; each call of Philox yields four numbers.
class RandomStream {
  public:
    /// All 64 bits of `seed` and `index` and the low 32 of `pass` address streams of their own
    /// (the high bits of `pass` too, but for collisions with other seeds).
    RandomStream(std::uint64_t seed, std::uint64_t pass, std::uint64_t index, RandomDomain domain)
        : counter_{{std::uint32_t(domain) << 24, std::uint32_t(index), std::uint32_t(index >> 32),
                    std::uint32_t(pass)}} {
        const std::uint64_t key = seed ^ ((pass >> 32) * 0x9E3779B97F4A7C15u);
        key_ = {{std::uint32_t(key), std::uint32_t(key >> 32)}};
    }

    /// 32 uniform bits.
    std::uint32_t next_uint() {
        if (used_ == 4) refill();
        return block_.v[used_++];
    }
    /// Uniform in [0, 1): a multiple of 2^-24, never 1.
    float next() { return to_unit_float(next_uint()); }
    /// Two numbers, x drawn first.
    Vec2 next2() {
        const float x = next();
        return {x, next()};
    }

  private:
    void refill() {
        block_ = r123::Philox4x32()(counter_, key_);
        ++counter_.v[0];
        used_ = 0;
    }

    r123::Philox4x32::ctr_type counter_;
    r123::Philox4x32::key_type key_{};
    r123::Philox4x32::ctr_type block_{};
    unsigned used_ = 4;
};

}  // namespace aips
