// Leaves of a primary tree around points that were found close together.
#include <algorithm>
#include <vector>

#include "aips/core/trees/primary_tree.h"

namespace aips {
namespace {

/// One seed in so many may lie apart at either end, so that three quarters count.
constexpr std::size_t kFocusApart = 8;

/// Length that holds the points along the axis, without those apart; reorders `scratch`.
double extent_of(std::span<const PrimaryPoint> points, unsigned axis,
                 std::vector<double>& scratch) {
    scratch.clear();
    for (const PrimaryPoint& p : points)
        scratch.push_back(p[axis]);
    const auto apart = static_cast<std::ptrdiff_t>(points.size() / kFocusApart);
    const auto low = scratch.begin() + apart;
    const auto high = scratch.end() - 1 - apart;
    std::nth_element(scratch.begin(), low, scratch.end());
    const double least = *low;
    std::nth_element(scratch.begin(), high, scratch.end());
    return *high - least;
}

}  // namespace

unsigned PrimaryTree::narrow_axis(const Leaf& leaf, std::span<const PrimaryPoint> points) {
    unsigned narrowest = kLeafAxis;
    double least = kFocusNarrow;
    std::vector<double> scratch;
    for (unsigned axis = 0; axis < 4; ++axis) {
        if (leaf.side[axis] <= kMinSide) continue;
        const double share = extent_of(points, axis, scratch) / leaf.side[axis];
        if (share >= least) continue;
        least = share;
        narrowest = axis;
    }
    return narrowest;
}

void PrimaryTree::focus(std::span<PrimaryPoint> points) {
    focus(0, {}, {1, 1, 1, 1}, points);
}

void PrimaryTree::focus(std::uint32_t node, PrimaryPoint corner, PrimaryPoint side,
                        std::span<PrimaryPoint> points) {
    if (points.size() < kFocusPoints) return;
    if (nodes_[node].is_leaf()) {
        // The other half of the leaves is for what photons tell.
        if (leaf_count() >= settings_.max_leaves / 2) return;
        const unsigned axis = narrow_axis(leaves_[nodes_[node].target()], points);
        if (axis == kLeafAxis) return;
        split(node, axis);
    }
    const unsigned axis = nodes_[node].axis();
    const std::uint32_t lower = nodes_[node].target();
    side[axis] *= 0.5;
    const double middle = corner[axis] + side[axis];
    const auto upper = std::stable_partition(
        points.begin(), points.end(), [&](const PrimaryPoint& p) { return p[axis] < middle; });
    const auto below = static_cast<std::size_t>(upper - points.begin());
    focus(lower, corner, side, points.first(below));
    corner[axis] = middle;
    focus(lower + 1, corner, side, points.subspan(below));
}

}  // namespace aips
