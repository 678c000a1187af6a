// Many Markov chains side by side over one function, renewed one after the other.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "path/metropolis_chain.h"

namespace lxs {

/// Draws `count` of the samples with replacement, each in proportion to its brightness: systematic
/// resampling. Any one of the draws alone has that distribution, not only all together. `offset`
/// in [0,1) is uniform. The sum of `brightness` must be positive.
std::vector<std::size_t> resample(std::span<const double> brightness, std::size_t count,
                                  double offset);

/// Where a chain starts when it runs next.
struct ChainStart {
    std::optional<RandomStream> sample;  ///< none: all samples were dark
    double mean = 0;                     ///< B
};

/// Chains whose image is right in expectation after any number of passes. Every chain starts from
/// plain samples of its own time and keeps the weight that they give it, their mean brightness B
/// (Veach 1997, section 11.3.1). Large steps are plain samples too, independent of what the chains
/// are at: as soon as enough of them are there, they renew some of the chains, in turn. So rare
/// bright points count as soon and as often as large steps find them (compare Cline, Talbot &
/// Egbert 2005, "Energy redistribution path tracing"), whereas chains that go on for ever, scaled
/// by one estimate of b, wait for them as long as they take to mix.
class MetropolisPopulation {
  public:
    /// The image has `width` x `height` pixels and `groups` light groups; a pass makes as many
    /// mutations as there are pixels.
    MetropolisPopulation(const MetropolisSettings& settings, std::uint32_t width,
                         std::uint32_t height, std::uint32_t groups, std::uint64_t seed);

    /// Number of plain samples that guess b, and of those that start the chains.
    std::size_t starting_samples() const { return starting_samples_; }
    /// The plain samples of the beginning, by number.
    RandomStream plain_sample(std::uint64_t index) const;
    /// Adds the I of the next starting_samples(), from which b is guessed. False if all so far were
    /// dark: then others have to be asked before anything else can be done.
    bool guess_from(std::span<const double> brightness);
    bool has_guess() const { return guess_ > 0; }
    /// Starts all chains from the starting_samples() that come next, given their I.
    void start_from(std::span<const double> brightness);

    std::size_t chains() const { return lanes_.size(); }
    /// One chain's share of a pass. Different chains may run at the same time.
    void run(std::size_t chain, MetropolisTarget& target);

    struct Splats {
        std::span<const Vec2> positions;
        std::span<const Rgb> radiance;  ///< light groups of the first splat, of the second, ...
        std::uint64_t mutations = 0;    ///< that they stand for
    };
    /// Ends the pass in which all chains have run; what it gives is there until the next.
    Splats finish_pass();

    /// Between one pass and the next.
    void state(StateArchive& archive);

    const ChainCounts& counts() const { return total_; }
    /// How often a chain was given a start, the first ones included.
    std::uint64_t starts() const { return starts_; }
    /// Number of plain samples so far, large steps included.
    std::uint64_t plain_samples() const { return plain_samples_ + total_.large; }
    /// Estimate of b from all of them; 0 if there are none.
    double mean_brightness() const;

  private:
    /// A chain, its share of a pass and what it did with it.
    struct Lane {
        MetropolisChain chain;
        std::uint64_t mutations = 0;
        std::size_t first_splat = 0;
        std::size_t splats = 0;
        ChainCounts counts{};
        std::vector<LitSample> lit{};  ///< since the last renewal
        std::optional<ChainStart> start{};
    };

    /// Lets the lanes first, first + stride, ... start from some of `brightness`.
    void assign(std::span<const double> brightness, std::uint64_t samples, std::size_t first,
                std::size_t stride, const std::function<RandomStream(std::size_t)>& sample);
    void renew_some();
    void lane_state(StateArchive& archive, Lane& lane);

    std::uint64_t seed_;
    std::uint32_t groups_;
    std::size_t starting_samples_;
    std::vector<Lane> lanes_;
    std::vector<Vec2> positions_;
    std::vector<Rgb> radiance_;
    double guess_ = 0;  ///< of b, made of samples that start no chain; 0 until one had light
    double plain_brightness_ = 0;
    std::uint64_t plain_samples_ = 0;
    std::uint64_t large_since_renewal_ = 0;
    std::uint64_t assignments_ = 0;
    std::uint64_t renewals_ = 0;  ///< turns, of some chains each
    std::uint64_t starts_ = 0;
    ChainCounts total_;
};

}  // namespace lxs
