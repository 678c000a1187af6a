// Where a score cache gets finer.
#include <algorithm>
#include <cmath>
#include <vector>

#include "aips/core/trees/score_cache.h"
#include "trees/usable_bounds.h"

namespace aips {

float ScoreCache::fitted_side(const Leaf& leaf, int axis) const {
    return std::max(min_side_, leaf.met.upper[axis] - leaf.met.lower[axis]);
}

/// Moves the box to where the leaf's vertices lie if that is far smaller or larger: a room in a
/// wide scene, or a surface below those that came first. True if it did; the probe starts anew.
bool ScoreCache::fit_box(Leaf& leaf) const {
    bool changed = false;
    for (int axis = 0; axis < 3; ++axis) {
        const float side = std::max(min_side_, leaf.box.upper[axis] - leaf.box.lower[axis]);
        const float fitted = fitted_side(leaf, axis);
        if (fitted >= 0.5f * side && fitted <= 2 * side) continue;
        leaf.box.lower[axis] = leaf.met.lower[axis];
        leaf.box.upper[axis] = leaf.met.lower[axis] + fitted;
        changed = true;
    }
    if (changed) leaf.probe = {};
    return changed;
}

bool ScoreCache::divisible(const Leaf& leaf, int axis) const {
    const float side = leaf.box.upper[axis] - leaf.box.lower[axis];
    return side > 0 && side >= 2 * min_side_;
}

double ScoreCache::leaf_mass(std::uint32_t branch) const {
    return std::sqrt(totals_[branch].score * totals_[branch].cost);
}

ScoreCache::Split ScoreCache::best_split(std::uint32_t branch, double whole_mass) const {
    const Leaf& leaf = leaves_[branches_[branch].target()];
    const double mass = leaf_mass(branch) / whole_mass;
    Split best{settings_.split_gain, branch};
    for (int axis = 0; axis < 3; ++axis) {
        if (!divisible(leaf, axis) || !leaf.probe.halves_differ(axis)) continue;
        const double gain = leaf.probe.gain(axis) * mass;
        if (gain > best.gain) best = {gain, branch, axis};
    }
    if (best.axis != kLeaf || mass <= settings_.split_mass) return best;
    const int longest = leaf.box.longest_axis();
    if (divisible(leaf, longest)) best.axis = longest;
    return best;
}

// Greedy, one level at each call and leaf: the probes of new leaves are first to be filled.
void ScoreCache::split_leaves() {
    double whole_mass = 0;
    for (std::uint32_t i = 0; i < branches_.size(); ++i) {
        if (branches_[i].axis() == kLeaf) whole_mass += leaf_mass(i);
    }
    if (!(whole_mass > 0) || leaf_count() >= settings_.max_leaves) return;
    std::vector<Split> splits;
    for (std::uint32_t i = 0; i < branches_.size(); ++i) {
        if (branches_[i].axis() != kLeaf) continue;
        Leaf& leaf = leaves_[branches_[i].target()];
        if (leaf.probe.scored.whole < settings_.split_count) continue;
        if (fit_box(leaf)) continue;
        const Split best = best_split(i, whole_mass);
        if (best.axis != kLeaf) splits.push_back(best);
    }
    std::stable_sort(splits.begin(), splits.end(),
                     [](const Split& a, const Split& b) { return a.gain > b.gain; });
    for (const Split& s : splits) {
        if (leaf_count() >= settings_.max_leaves) break;
        split(s);
    }
}

// The halves inherit what the probe met in them, which is exact; how older vertices lay is unknown
// and they are dropped, as is, in the new probes, how the inherited ones lay along other planes.
void ScoreCache::split(const Split& split) {
    const std::uint32_t lower = branches_[split.branch].target();
    const auto upper = static_cast<std::uint32_t>(leaves_.size());
    const auto child = static_cast<std::uint32_t>(branches_.size());
    const Leaf whole = leaves_[lower];
    const float plane = halving_plane(whole.box, split.axis);
    leaves_.push_back(whole);
    leaves_.back().parent = lower;
    for (const bool is_upper : {false, true}) {
        Leaf& leaf = leaves_[is_upper ? upper : lower];
        (is_upper ? leaf.box.lower : leaf.box.upper)[split.axis] = plane;
        leaf.met = {};
        leaf.probe = {};
        branches_.push_back({0, (is_upper ? upper : lower) * 4 + kLeaf});
        means_.push_back({});
        totals_.push_back(whole.probe.half(split.axis, is_upper));
    }
    branches_[split.branch] = {plane, child * 4 + std::uint32_t(split.axis)};
}

}  // namespace aips
