// What is expected in the leaves of a primary tree: their own mean, joined by their parents'.
#include "aips/core/trees/primary_tree.h"

namespace aips {

void PrimaryTree::Totals::add(const Totals& other) {
    volume += other.volume;
    root += other.root;
    variance += other.variance;
    drawn += other.drawn;
    cost += other.cost;
}

PrimaryTree::Means PrimaryTree::Totals::blend(const Means& prior, double prior_drawn) const {
    const double all = drawn + prior_drawn;
    if (!(all > 0)) return prior;
    return {(drawn * root / volume + prior_drawn * prior.root) / all,
            (cost + prior_drawn * prior.cost) / all, prior.drawn_per_score};
}

PrimaryTree::Totals PrimaryTree::totals_of(const Leaf& leaf) {
    Totals totals;
    totals.volume = leaf.volume;
    totals.drawn = leaf.drawn;
    totals.cost = leaf.cost;
    if (leaf.paths > 0) {
        totals.root = leaf.root.whole / leaf.paths;
        totals.variance = leaf.score / (leaf.paths * leaf.paths);
    }
    return totals;
}

// Children come after their parents.
void PrimaryTree::set_expectations() {
    totals_.assign(nodes_.size(), {});
    means_.assign(nodes_.size(), {});
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        const Node& node = nodes_[i];
        if (node.is_leaf()) {
            totals_[i] = totals_of(leaves_[node.target()]);
            continue;
        }
        totals_[i].add(totals_[node.target()]);
        totals_[i].add(totals_[node.target() + 1]);
    }
    means_[0] = totals_[0].blend({}, 0);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const Node& node = nodes_[i];
        if (node.is_leaf()) {
            leaves_[node.target()].expected = means_[i];
            continue;
        }
        // Where one photon in a hundred has a score, some hundred zeros prove nothing; below nodes
        // without any score what is above them tells how many do.
        const double effective = totals_[i].effective_count();
        if (effective > 0) means_[i].drawn_per_score = totals_[i].drawn / effective;
        const double prior = settings_.prior_count * means_[i].drawn_per_score;
        for (const std::uint32_t child : {node.target(), node.target() + 1})
            means_[child] = totals_[child].blend(means_[i], prior);
    }
}

}  // namespace aips
