// A chain of specular surfaces before the eye, with its choices, and where it looks from its end.
#pragma once

#include <array>
#include <cstdint>

#include "eye/eye_pass.h"

namespace aips {

/// Which surfaces a chain has, and which ways it takes there: film positions close by are on the
/// same chain.
struct SpecularChain {
    static constexpr unsigned kMost = 16;
    struct Link {
        std::uint32_t material = 0;
        float first = 0;          ///< probability of the first of two ways; 0: there is one
        bool takes_first = true;  ///< of the two
    };
    std::array<Link, kMost> links{};
    unsigned length = 0;
};

/// A surface of a chain, and the direction in which it is left.
struct ChainVertex {
    SurfacePoint point;  ///< its Bsdf is null
    Vec3 direction;
    float first = 0;  ///< as SpecularChain::Link has it
};

/// [surface] of a chain.
using ChainVertices = std::array<ChainVertex, SpecularChain::kMost>;

/// Follows chains of specular surfaces through the middle of the lens; counts rays.
class ChainTracer {
  public:
    ChainTracer(const EyePassInput& input, float time, InvalidSampleFilter& filter, Arena& arena)
        : in_(input), time_(time), filter_(filter), arena_(arena) {}

    /// The chain at a film position (pixels), ways taken at random, as long as there are specular
    /// surfaces.
    SpecularChain explore(Vec2 film, RandomStream& random, ChainVertices& vertices);
    /// Follows the first `length` links of `chain` from another position, and notes the
    /// probabilities of ways there; how many of them are there.
    unsigned follow(SpecularChain& chain, unsigned length, Vec2 film, ChainVertices& vertices);
    /// What follow() would note again at a position of which the first `length` vertices are kept.
    /// Their rays count as if they were traced: how much work is planned depends on the number of
    /// rays, and is to be the same whether something was kept or not.
    void recall(SpecularChain& chain, unsigned length, const ChainVertices& vertices);

    std::uint32_t rays() const { return rays_; }

  private:
    template <class Way>
    unsigned trace(Vec2 film, unsigned most, ChainVertices& vertices, const Way& way);

    const EyePassInput& in_;
    float time_;
    InvalidSampleFilter& filter_;
    Arena& arena_;
    std::uint32_t rays_ = 0;
};

}  // namespace aips
