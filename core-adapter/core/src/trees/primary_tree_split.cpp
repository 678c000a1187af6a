// Where a density over primary coordinates gets finer.
#include <algorithm>
#include <cmath>

#include "aips/core/trees/primary_tree.h"

namespace aips {
namespace {

/// Share of its history that a new leaf of a light's tree keeps: how the score lay within the half
/// is a guess.
constexpr double kInheritedHistory = 0.1;

/// How far a sum spreads over its leaf: falls when it lies in one half. For a density proportional
/// to the sum in each leaf, it is the volume that the density is spread over that falls.
double spread_of(double sum, double volume) {
    return std::sqrt(sum * volume);
}

}  // namespace

// Greedy, one level at each call and leaf: the sums of new leaves are first to be learned anew.
void PrimaryTree::split_leaves() {
    double learned = 0, seeds = 0;
    for (const Leaf& leaf : leaves_) {
        learned += leaf.paths > 0 ? spread_of(leaf.root.whole / leaf.paths, leaf.volume) : 0;
        seeds += spread_of(leaf.seeds.whole, leaf.volume);
    }
    const auto fall = [](const Leaf& leaf, const Sums& sums, unsigned axis) {
        const double lower = sums.lower[axis];
        const double upper = std::max(0.0, sums.whole - lower);
        return spread_of(sums.whole, leaf.volume) - spread_of(lower, 0.5 * leaf.volume) -
               spread_of(upper, 0.5 * leaf.volume);
    };
    const auto gain_of = [&](const Leaf& leaf, unsigned axis) {
        double gain = 0;
        if (learned > 0 && leaf.paths > 0) {
            gain = fall(leaf, leaf.root, axis) / std::sqrt(leaf.paths) / learned;
        }
        return seeds > 0 ? std::max(gain, fall(leaf, leaf.seeds, axis) / seeds) : gain;
    };
    struct Candidate {
        double gain;
        std::uint32_t node;
        unsigned axis;
    };
    std::vector<Candidate> candidates;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        if (!nodes_[i].is_leaf()) continue;
        const Leaf& leaf = leaves_[nodes_[i].target()];
        if (leaf.met.whole < settings_.split_count) continue;
        Candidate best{settings_.split_gain, i, kLeafAxis};
        for (unsigned axis = 0; axis < 4; ++axis) {
            if (leaf.side[axis] <= kMinSide) continue;
            const double gain = gain_of(leaf, axis);
            if (gain > best.gain) best = {gain, i, axis};
        }
        if (best.axis != kLeafAxis) candidates.push_back(best);
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.gain > b.gain; });
    for (const Candidate& c : candidates) {
        if (leaf_count() >= settings_.max_leaves) break;
        split(c.node, c.axis);
    }
}

void PrimaryTree::split(std::uint32_t node, unsigned axis) {
    const std::uint32_t lower = nodes_[node].target();
    const auto upper = static_cast<std::uint32_t>(leaves_.size());
    const Leaf whole = leaves_[lower];
    leaves_.push_back(whole);
    for (const bool is_upper : {false, true}) {
        Leaf& leaf = leaves_[is_upper ? upper : lower];
        leaf.side[axis] *= 0.5;
        leaf.volume *= 0.5;
        if (is_upper) leaf.corner[axis] += leaf.side[axis];
        leaf.root = whole.root.half(axis, is_upper);
        leaf.seeds = whole.seeds.half(axis, is_upper);
        leaf.root.scale(kInheritedHistory);
        leaf.score *= 0.5 * kInheritedHistory;
        leaf.drawn *= 0.5 * kInheritedHistory;
        leaf.cost *= 0.5 * kInheritedHistory;
        leaf.paths *= kInheritedHistory;
        leaf.met = {};
    }
    const auto child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(leaf_node(lower));
    nodes_.push_back(leaf_node(upper));
    nodes_[node].packed = child * 8 + axis;
}

}  // namespace aips
