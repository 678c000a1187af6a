// A Markov chain that spreads the weight of paths drawn before over the visible paths near them.
// Sources: Cline et al. 2005, "Energy Redistribution Path Tracing" (many short chains, each from a
// path of its own); Del Moral et al. 2006, "Sequential Monte Carlo Samplers" (resampling, then
// moves that keep the target).
#pragma once

#include <utility>

#include "aips/core/chains/primary_path.h"
#include "aips/core/chains/visibility_chain.h"

namespace aips {

/// Walks in segments of equal length among visible paths. A segment starts at a path drawn in
/// proportion to its weight from n independent ones; mutations follow, accepted when visible.
///
/// With Z the sum of the weights of the visible ones among them over n, and X the state at any
/// fixed step of a segment, E[Z f(X)] is the integral of f over the visible paths: at the start, as
/// X is path i with probability w_i / (n Z), it is E[sum of w_i f(x_i)] / n; and a mutation, which
/// knows nothing of Z, keeps the uniform measure on the visible paths and so the integral. The
/// start alone would not have the right distribution; Z times it has. It takes a number n fixed in
/// advance, and steps, segments' lengths and sizes of mutations that depend on none of the n paths.
template <class Payload>
class SpreadChain {
  public:
    /// Before the first step of a pass.
    void begin_pass() { step_ = 0; }

    /// Takes exactly `paths` steps of one path each. `start(coordinates, payload, segment)` fills
    /// both, which come as they were left, with the visible path that segment number `segment` of
    /// this chain starts at; `trace` as in VisibilityChain; `record(coordinates, payload, repeats)`
    /// takes each state with the number of steps that it lasted.
    template <class Start, class Trace, class Record>
    void run(const ChainAddress& address, std::uint32_t paths, float exponent,
             std::uint64_t segment_steps, Start&& start, Trace&& trace, Record&& record,
             ChainCounts& counts) {
        std::uint32_t repeats = 0;
        const auto leave = [&] {
            if (repeats > 0)
                record(std::span<const Coordinate>(current_.coordinates),
                       std::as_const(current_.payload), std::exchange(repeats, 0));
        };
        for (; paths > 0; --paths, ++step_) {
            if (step_ % segment_steps == 0) {
                leave();
                start(current_.coordinates, current_.payload, step_ / segment_steps);
            } else {
                const std::uint64_t number = step_ * address.chains + address.chain;
                const RandomStream random(address.seed, address.pass, number,
                                          RandomDomain::MutatedPath);
                proposed_.coordinates.clear();
                PrimaryPath path(random, current_.coordinates, exponent, proposed_.coordinates);
                ++counts.mutated;
                if (trace(path, proposed_.payload, number)) {
                    ++counts.accepted;
                    leave();
                    std::swap(current_, proposed_);
                }
            }
            ++repeats;
            ++counts.recorded;
        }
        leave();
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
    std::uint64_t step_ = 0;  // of this pass
};

}  // namespace aips
