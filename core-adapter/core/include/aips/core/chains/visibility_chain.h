// A Markov chain over paths whose target is uniform on the visible ones.
// Source: Hachisuka & Jensen 2011: a chain of independent paths and a chain of mutated ones, joined
// by replica exchange, which for a binary target means: whenever an independent path is visible,
// the mutated chain goes on from it.
#pragma once

#include <utility>

#include "aips/core/chains/primary_path.h"

namespace aips {

/// Counts over chains. The visible share of all paths is estimated by visible / measured.
struct ChainCounts {
    std::uint64_t uniform = 0;   ///< independent paths traced
    std::uint64_t measured = 0;  ///< of these, the ones that measure the visible share
    std::uint64_t visible = 0;   ///< of the measured, visible
    std::uint64_t mutated = 0;   ///< mutated paths traced
    std::uint64_t accepted = 0;  ///< of these, visible
    std::uint64_t recorded = 0;  ///< steps that left the chain at a visible path

    /// Saves or restores the counts.
    void state(StateArchive& archive) {
        for (std::uint64_t* count : {&uniform, &measured, &visible, &mutated, &accepted, &recorded})
            archive.value(*count);
    }

    ChainCounts& operator+=(const ChainCounts& o) {
        uniform += o.uniform;
        measured += o.measured;
        visible += o.visible;
        mutated += o.mutated;
        accepted += o.accepted;
        recorded += o.recorded;
        return *this;
    }
};

/// Addresses the random numbers of a chain.
struct ChainAddress {
    std::uint64_t seed = 0, pass = 0;
    std::uint32_t chain = 0;   ///< number of this chain
    std::uint32_t chains = 1;  ///< number of chains
};

/// One chain. `Payload` is what a visible path leaves (its photons); its memory is used again.
///
/// Given where the independent paths were visible, each recorded state is distributed uniformly
/// over the visible paths, from the first step on: it starts at an independent visible path, and
/// the moves (an independent visible path; a symmetric mutation accepted when visible) keep that
/// distribution. So the mean over recorded states times visible / measured is the mean over all
/// paths, without start-up bias, as long as the size of mutations does not depend on the states
/// and the number of measured paths is fixed: within a budget of paths, more visible ones leave
/// time for more independent ones, and counting all of them would be biased where few are visible.
template <class Payload>
class VisibilityChain {
  public:
    bool has_state() const { return has_state_; }
    /// Before the first step of a pass. The first `measured` independent paths measure the visible
    /// share; half of the pass's paths, rounded up, are sure to be independent.
    void begin_pass(std::uint64_t measured) {
        has_state_ = false;
        step_ = 0;
        measured_ = measured;
    }
    /// Goes on from the state of another chain, which must have one.
    void adopt(const VisibilityChain& other) {
        current_ = other.current_;
        has_state_ = true;
    }

    /// Traces exactly `paths` paths. `trace(PrimaryPath&, Payload&, number)` replaces the payload
    /// and says whether the path is visible; `record(const Payload&, repeats)` takes each state
    /// with the number of steps that it lasted.
    template <class Trace, class Record>
    void run(const ChainAddress& address, std::uint32_t paths, float exponent, Trace&& trace,
             Record&& record, ChainCounts& counts) {
        std::uint32_t repeats = 0;
        const auto propose = [&](RandomDomain domain, std::span<const Coordinate> from) {
            const std::uint64_t number = step_ * address.chains + address.chain;
            const RandomStream random(address.seed, address.pass, number, domain);
            proposed_.coordinates.clear();
            PrimaryPath path(random, from, exponent, proposed_.coordinates);
            if (!trace(path, proposed_.payload, number)) return false;
            if (repeats > 0) record(std::as_const(current_.payload), std::exchange(repeats, 0));
            std::swap(current_, proposed_);
            has_state_ = true;
            return true;
        };
        while (paths > 0) {
            const bool measuring = step_ < measured_;
            --paths;
            ++counts.uniform;
            counts.measured += measuring;
            if (propose(RandomDomain::UniformPath, {})) {
                counts.visible += measuring;
            } else if (has_state_ && paths > 0) {
                // Where no path is left for a mutation the state lasts: a valid, idle step.
                --paths;
                ++counts.mutated;
                counts.accepted += propose(RandomDomain::MutatedPath, current_.coordinates);
            }
            ++step_;
            if (!has_state_) continue;
            ++repeats;
            ++counts.recorded;
        }
        if (repeats > 0) record(std::as_const(current_.payload), repeats);
    }

    std::size_t coordinate_bytes() const {
        return (current_.coordinates.capacity() + proposed_.coordinates.capacity()) *
               sizeof(Coordinate);
    }
    const Payload& current() const { return current_.payload; }
    const Payload& proposed() const { return proposed_.payload; }

  private:
    struct State {
        std::vector<Coordinate> coordinates;
        Payload payload;
    };
    State current_, proposed_;
    std::uint64_t step_ = 0;      // of this pass
    std::uint64_t measured_ = 0;  // steps of this pass that measure
    bool has_state_ = false;
};

}  // namespace aips
