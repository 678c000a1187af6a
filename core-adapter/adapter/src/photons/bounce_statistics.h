// How many photon bounces each node of a guide saw, and how many of them were guided: a debug view.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "aips/adapter/guide.h"

namespace aips {

/// Counts bounces by the guide's node, over one pass. A node that splits leaves half of its counts
/// to each child: nodes split at the median of their photons, and where each bounce was is not
/// kept.
class BounceStatistics {
  public:
    /// `guide` outlives the statistics and never has more than `max_nodes` nodes.
    BounceStatistics(const Guide& guide, std::uint32_t max_nodes);

    /// Forgets the last pass.
    void begin_pass();
    /// Makes room for the nodes that the guide's last update has added.
    void follow_splits();
    /// A bounce off a non-specular lobe. May be called from many threads while the guide is frozen:
    /// sums of integers do not depend on their order.
    void count(Vec3 position, bool guided);

    /// Share of the node's bounces in this pass whose direction was drawn from the guide, in
    /// [0, 1]; 0 without bounces.
    float guided_share(std::uint32_t node) const;

    std::size_t memory_bytes() const { return counts_.capacity() * sizeof(Count); }
    static std::size_t memory_bound_bytes(std::uint32_t max_nodes) {
        return max_nodes * sizeof(Count);
    }

  private:
    struct Count {
        std::uint64_t bounces = 0;
        std::uint64_t guided = 0;
    };

    const Guide& guide_;
    std::vector<Count> counts_;  // [node]
};

}  // namespace aips
