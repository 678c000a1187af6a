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

/// A large step that found light: a plain sample that a chain may start from.
struct LitSample {
    std::uint64_t mutation = 0;  ///< its number in its chain
    double brightness = 0;       ///< I > 0
};

struct ChainCounts {
    std::uint64_t mutations = 0;
    std::uint64_t accepted = 0;
    std::uint64_t large = 0;           ///< large steps
    std::uint64_t accepted_large = 0;  ///< of `accepted`
    std::uint64_t forced = 0;          ///< of `accepted`: after too many rejections in a row
    double large_brightness = 0;       ///< sum of I over large steps: plain samples of b

    ChainCounts& operator+=(const ChainCounts& other);
    void state(StateArchive& archive);
};

/// A chain x_0, x_1, ... with density I / b in the limit. Each mutation gives both states their
/// expected share (Veach 1997, section 11.5), and large steps count as plain samples as well, the
/// two combined by the balance heuristic (Kelemen et al. 2002, section 5). With acceptance
/// probability a = min(1, I(y) / I(x)) of the proposal y, the image gains
///
///     f(y) (a B/c + large) / (I(y)/c + p_large)  +  f(x) ((1 - a) B/c) / (I(x)/c + p_large)
///
/// per mutation. B is the mean of I over the plain samples that x_0 was drawn from, and the
/// constant c guesses b; with B = c = b this is Kelemen's formula. For any c the weights of the two
/// densities sum to one, so that a poor guess costs variance but no bias, if it is made of other
/// samples than those that x_0 was drawn from.
class MetropolisChain {
  public:
    /// `width` and `height` of the film in pixels; `index` addresses the chain's random numbers.
    MetropolisChain(const MetropolisSettings& settings, std::uint32_t width, std::uint32_t height,
                    std::uint64_t seed, std::uint32_t index);

    /// Begins anew at the point that `sample` gives, which must have I > 0. If it was drawn in
    /// proportion to I among plain samples, and `mean` is the mean of I over all of these, what the
    /// chain gives has the right expectation from then on, however few the samples, however short
    /// the chain (Veach 1997, section 11.3.1). The product of both is right, not `mean` over what
    /// other samples say of b.
    void start(const RandomStream& sample, double mean, MetropolisTarget& target);
    /// Likewise where all of the plain samples were dark.
    void start_dark();
    /// Makes `mutations` moves; `splats` needs room for one more than that. `guess` is c. Appends
    /// large steps that found light to `lit`.
    ChainCounts run(std::uint64_t mutations, double guess, MetropolisTarget& target,
                    SplatList& splats, std::vector<LitSample>& lit);
    /// Of all that the chain is at, between one run and the next, on a film with `groups` groups.
    void state(StateArchive& archive, std::uint32_t groups);
    /// The point of primary sample space that the chain's mutation number `mutation` is if large.
    RandomStream plain_sample(std::uint64_t mutation) const;

  private:
    struct State {
        Contribution contribution;
        double weight = 0;  ///< expected number of visits not yet given to the image
    };

    void step(double guess, MetropolisTarget& target, SplatList& splats, ChainCounts& counts,
              std::vector<LitSample>& lit);
    void give(State& state, double guess, SplatList& splats) const;

    MetropolisSettings settings_;
    std::uint64_t seed_;
    std::uint32_t index_;
    MetropolisCoordinates coordinates_;
    State present_, proposed_;
    double mean_ = 0;  ///< B
    std::uint64_t mutations_ = 0;
    std::uint64_t rejects_in_a_row_ = 0;
};

}  // namespace lxs
