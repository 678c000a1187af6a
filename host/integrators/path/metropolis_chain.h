// One Markov chain of primary-sample-space Metropolis sampling, over any function.
//
// References: Veach & Guibas 1997, "Metropolis light transport"; Kelemen, Szirmay-Kalos, Antal &
// Csonka 2002, "A simple and robust mutation strategy for the Metropolis light transport
// algorithm". The names I, b and p_large are theirs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lxs/sdk/camera.h"
#include "path/metropolis_coordinates.h"

namespace lxs {

/// What one point of primary sample space gives the image.
struct Contribution {
    Vec2 position{0.0f};        ///< on the film, pixels
    std::vector<Rgb> radiance;  ///< by light group
    double brightness = 0;      ///< I, what chains sample in proportion to: finite, >= 0
};

/// The function that chains explore.
class MetropolisTarget {
  public:
    virtual ~MetropolisTarget() = default;
    /// Overwrites `contribution`; a pure function of the sample's numbers.
    virtual void evaluate(PrimarySample& sample, Contribution& contribution) = 0;
};

/// Room for splats, filled from the front.
struct SplatList {
    std::span<Vec2> positions;
    std::span<Rgb> radiance;  ///< light groups of the first splat, of the second, ...
    std::size_t used = 0;

    void add(const Contribution& contribution, double weight);
};

/// Two estimates of b, the mean of I over primary sample space, both fixed before they are used.
struct MeanBrightness {
    double guess;     ///< weighs large steps against the chain; any positive value is right
    double estimate;  ///< scales what the chain gives; the image is as bright as this is right
};

struct ChainCounts {
    std::uint64_t mutations = 0;
    std::uint64_t accepted = 0;
    std::uint64_t large = 0;           ///< large steps
    std::uint64_t accepted_large = 0;  ///< of `accepted`
    std::uint64_t forced = 0;          ///< of `accepted`: after too many rejections in a row
    double large_brightness = 0;       ///< sum of I over large steps: plain samples of b

    ChainCounts& operator+=(const ChainCounts& other);
};

/// A chain x_0, x_1, ... with density I / b in the limit. Each mutation gives both states their
/// expected share (Veach 1997, section 11.5), and large steps count as plain samples as well, the
/// two combined by the balance heuristic (Kelemen et al. 2002, section 5). With acceptance
/// probability a = min(1, I(y) / I(x)) of the proposal y, the image gains
///
///     f(y) (a b'/c + large) / (I(y)/c + p_large)  +  f(x) ((1 - a) b'/c) / (I(x)/c + p_large)
///
/// per mutation, where b' estimates b and the constant c guesses it; with c = b' this is Kelemen's
/// formula. Apart from b'/c the weights of the two densities, I/b and 1, sum to one for any c, so
/// that a poor guess costs variance but no bias.
class MetropolisChain {
  public:
    /// `width` and `height` of the film in pixels; `index` addresses the chain's random numbers.
    MetropolisChain(const MetropolisSettings& settings, std::uint32_t width, std::uint32_t height,
                    std::uint64_t seed, std::uint32_t index);

    /// Begins at the point that `sample` gives, which must have I > 0. Chosen in proportion to I
    /// among plain samples whose mean is b', it leaves no start-up bias (Veach 1997, section 11.3).
    void start(const RandomStream& sample, MetropolisTarget& target);
    /// Makes `mutations` moves; `splats` needs room for one more than that.
    ChainCounts run(std::uint64_t mutations, const MeanBrightness& b, MetropolisTarget& target,
                    SplatList& splats);

  private:
    struct State {
        Contribution contribution;
        double weight = 0;  ///< expected number of visits not yet given to the image
    };

    void step(const MeanBrightness& b, MetropolisTarget& target, SplatList& splats,
              ChainCounts& counts);
    void give(State& state, double guess, SplatList& splats) const;

    MetropolisSettings settings_;
    std::uint64_t seed_;
    std::uint32_t index_;
    MetropolisCoordinates coordinates_;
    State present_, proposed_;
    std::uint64_t mutations_ = 0;
    std::uint64_t rejects_in_a_row_ = 0;
};

}  // namespace lxs
