// What a score cache learned, saved and restored.
#include <cmath>

#include "aips/core/trees/score_cache.h"
#include "trees/split_order.h"

namespace aips {
namespace {

/// Of a leaf; an empty one is the wrong way round.
void state_of_box(StateArchive& archive, Bounds& box) {
    for (Vec3* corner : {&box.lower, &box.upper}) {
        for (int axis = 0; axis < 3; ++axis) {
            archive.value((*corner)[axis]);
            StateArchive::check(!std::isnan((*corner)[axis]), "a box without a corner");
        }
    }
}

}  // namespace

void ScoreCache::Totals::state(StateArchive& archive) {
    for (double* sum : {&count, &scored, &root, &score, &cost})
        archive.amount(*sum);
}

void ScoreCache::HalfSums::state(StateArchive& archive) {
    archive.amount(whole);
    archive.amounts(lower);
}

// What is expected follows from the leaves' totals. Boxes don't follow from the splits: they were
// fitted to the vertices met.
void ScoreCache::state(StateArchive& archive) {
    const auto divide = [&](std::uint32_t branch, int axis) {
        float plane = branches_[branch].plane;
        archive.value(plane);
        if (!archive.restoring()) return;
        StateArchive::check(std::isfinite(plane), "a plane that lies nowhere");
        split({0, branch, axis});
        branches_[branch].plane = plane;
    };
    state_of_splits(archive, branches_, kTrees, kLeaf, settings_.max_leaves - kTrees, divide);
    archive.amount(paths_);
    for (std::size_t i = 0; i < branches_.size(); ++i) {
        if (branches_[i].axis() != kLeaf) continue;
        totals_[i].state(archive);
        Leaf& leaf = leaves_[branches_[i].target()];
        state_of_box(archive, leaf.box);
        state_of_box(archive, leaf.met);
        for (HalfSums* sums : {&leaf.probe.count, &leaf.probe.scored, &leaf.probe.root,
                               &leaf.probe.score, &leaf.probe.cost})
            sums->state(archive);
    }
    if (!archive.restoring()) return;
    add_totals();
    set_means();
}

}  // namespace aips
