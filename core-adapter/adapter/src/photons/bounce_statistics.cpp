// Bounces per node.
#include "photons/bounce_statistics.h"

#include <atomic>

namespace aips {

BounceStatistics::BounceStatistics(const Guide& guide, std::uint32_t max_nodes) : guide_(guide) {
    counts_.reserve(max_nodes);
}

void BounceStatistics::begin_pass() {
    counts_.assign(guide_.statistics().nodes, Count{});
}

void BounceStatistics::follow_splits() {
    const std::size_t nodes = guide_.statistics().nodes;
    // Nodes are numbered in the order of splits: a parent that is new itself has its counts by now.
    while (counts_.size() < nodes) {
        const auto node = static_cast<std::uint32_t>(counts_.size());
        Count& parent = counts_[guide_.node(node).parent];
        parent = {parent.bounces / 2, parent.guided / 2};
        counts_.push_back(Count(parent));
    }
}

void BounceStatistics::count(Vec3 position, bool guided) {
    Count& count = counts_[guide_.node_at(position)];
    std::atomic_ref(count.bounces).fetch_add(1, std::memory_order_relaxed);
    if (guided) std::atomic_ref(count.guided).fetch_add(1, std::memory_order_relaxed);
}

float BounceStatistics::guided_share(std::uint32_t node) const {
    const Count& count = counts_[node];
    return count.bounces ? float(double(count.guided) / double(count.bounces)) : 0;
}

}  // namespace aips
