// Learning and sampling of a density over primary coordinates.
#include "aips/core/trees/primary_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "aips/core/sampling/sampling.h"
#include "trees/split_order.h"

namespace aips {
namespace {

/// The next numbers below x > 0.
float previous(float x) {
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) - 1);
}
double previous(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) - 1);
}

void check(const PrimaryTreeSettings& s) {
    if (s.max_leaves < 1 || s.max_leaves > kMostLeaves) {
        throw std::invalid_argument("PrimaryTree: max_leaves must be in [1, 2^24]");
    }
    if (s.split_count < 1) throw std::invalid_argument("PrimaryTree: split_count must be positive");
    if (!(s.split_gain >= 0)) throw std::invalid_argument("PrimaryTree: split_gain is negative");
    if (!(s.memory_paths > 0)) throw std::invalid_argument("PrimaryTree: memory_paths must be > 0");
    if (!(s.sharpness > 0 && s.sharpness <= 1)) {
        throw std::invalid_argument("PrimaryTree: sharpness must be in (0, 1]");
    }
    if (!(s.prior_count >= 0)) throw std::invalid_argument("PrimaryTree: prior_count is negative");
}

}  // namespace

void PrimaryTree::Sums::add(const std::array<bool, 4>& is_lower, double value) {
    whole += value;
    for (unsigned axis = 0; axis < 4; ++axis) {
        if (is_lower[axis]) lower[axis] += value;
    }
}

void PrimaryTree::Sums::scale(double factor) {
    whole *= factor;
    for (double& sum : lower)
        sum *= factor;
}

void PrimaryTree::Sums::state(StateArchive& archive) {
    archive.amount(whole);
    archive.amounts(lower);
}

PrimaryTree::Sums PrimaryTree::Sums::half(unsigned axis, bool upper) const {
    Sums result;
    result.whole = upper ? std::max(0.0, whole - lower[axis]) : lower[axis];
    const double share = whole > 0 ? result.whole / whole : 0;
    for (unsigned a = 0; a < 4; ++a)
        result.lower[a] = a == axis ? 0.5 * result.whole : share * lower[a];
    return result;
}

PrimaryTree::PrimaryTree(const PrimaryTreeSettings& settings) : settings_(settings) {
    check(settings);
    const std::size_t nodes = 2 * std::size_t(settings.max_leaves) - 1;
    nodes_.reserve(nodes);
    totals_.reserve(nodes);
    means_.reserve(nodes);
    probabilities_.reserve(nodes);
    leaves_.reserve(settings.max_leaves);
    nodes_.push_back(leaf_node(0));
    leaves_.push_back({});
}

PrimarySample PrimaryTree::sample(const PrimaryPoint& u) const {
    PrimaryPoint within = u, corner{}, side{1, 1, 1, 1};
    double pdf = 1;
    Node node = nodes_[0];
    while (!node.is_leaf()) {
        const unsigned axis = node.axis();
        const auto share = double(node.lower_share);
        double& x = within[axis];
        const bool upper = x >= share;
        side[axis] *= 0.5;
        corner[axis] += upper ? side[axis] : 0.0;
        x = (x - (upper ? share : 0)) * double(upper ? node.upper_scale : node.lower_scale);
        pdf *= 2 * (upper ? 1 - share : share);
        node = nodes_[node.target() + (upper ? 1u : 0u)];
    }
    PrimarySample sample;
    for (unsigned axis = 0; axis < 4; ++axis) {
        // Rounding must not move the point out of the leaf, where pdf() finds another density.
        const double end = previous(corner[axis] + side[axis]);
        const double x = corner[axis] + within[axis] * side[axis];
        sample.point[axis] = std::clamp(x, corner[axis], end);
    }
    sample.pdf = static_cast<float>(pdf);
    return sample;
}

PrimaryTree::Place PrimaryTree::locate(const PrimaryPoint& point) const {
    PrimaryPoint low{}, side{1, 1, 1, 1};
    Place place;
    Node node = nodes_[0];
    while (!node.is_leaf()) {
        const unsigned axis = node.axis();
        const auto share = double(node.lower_share);
        side[axis] *= 0.5;
        const bool upper = point[axis] >= low[axis] + side[axis];
        if (upper) low[axis] += side[axis];
        place.pdf *= 2 * (upper ? 1 - share : share);
        node = nodes_[node.target() + (upper ? 1u : 0u)];
    }
    place.leaf = node.target();
    return place;
}

float PrimaryTree::pdf(const PrimaryPoint& point) const {
    return static_cast<float>(locate(point).pdf);
}

std::array<bool, 4> PrimaryTree::lower_halves(const Leaf& leaf, const PrimaryPoint& point) const {
    std::array<bool, 4> lower{};
    for (unsigned axis = 0; axis < 4; ++axis)
        lower[axis] = point[axis] < leaf.corner[axis] + 0.5 * leaf.side[axis];
    return lower;
}

void PrimaryTree::add(const PrimaryPoint& point, double score, double cost) {
    if (!(score >= 0 && cost > 0) || !std::isfinite(score + cost)) return;
    Leaf& leaf = leaves_[locate(point).leaf];
    leaf.drawn += 1;
    leaf.cost += cost;
    if (score == 0) return;
    const auto lower = lower_halves(leaf, point);
    leaf.root.add(lower, std::sqrt(score));
    leaf.score += score;
    leaf.met.add(lower, 1);
}

void PrimaryTree::add_seed(const PrimaryPoint& point, double weight) {
    if (!(weight > 0) || !std::isfinite(weight)) return;
    Leaf& leaf = leaves_[locate(point).leaf];
    const auto lower = lower_halves(leaf, point);
    leaf.seeds.add(lower, weight);
    leaf.met.add(lower, 1);
}

void PrimaryTree::update(double paths) {
    for (Leaf& leaf : leaves_) {
        leaf.paths += std::max(0.0, paths);
        if (leaf.paths > settings_.memory_paths) {
            const double kept = settings_.memory_paths / leaf.paths;
            leaf.root.scale(kept);
            leaf.score *= kept;
            leaf.drawn *= kept;
            leaf.cost *= kept;
            leaf.paths = settings_.memory_paths;
        }
    }
    split_leaves();
    set_expectations();
}

void PrimaryTree::fade(double paths, double seeds) {
    for (Leaf& leaf : leaves_) {
        leaf.seeds.scale(seeds);
        if (!(leaf.paths > paths)) continue;
        const double kept = paths / leaf.paths;
        for (Sums* sums : {&leaf.root, &leaf.met})
            sums->scale(kept);
        for (double* sum : {&leaf.score, &leaf.drawn, &leaf.cost})
            *sum *= kept;
        leaf.paths = paths;
    }
    set_expectations();
}

double PrimaryTree::leaf_mass(const Leaf& leaf) const {
    if (!(leaf.expected.root > 0)) return 0;
    return leaf.volume *
           std::pow(leaf.expected.root / std::sqrt(leaf.expected.cost), settings_.sharpness);
}

void PrimaryTree::set_mixture(const PrimaryMixture& mixture) {
    double seeds = 0;
    for (const Leaf& leaf : leaves_)
        seeds += leaf.seeds.whole;
    const double learned = mass();
    const double seed_share = seeds > 0 ? mixture.seeds : 0;
    const double learned_share = learned > 0 ? 1 - mixture.plain - mixture.seeds : 0;
    const double plain_share = 1 - seed_share - learned_share;
    for (Leaf& leaf : leaves_) {
        double probability = plain_share * leaf.volume;
        if (seeds > 0) probability += seed_share * leaf.seeds.whole / seeds;
        if (learned > 0) probability += learned_share * leaf_mass(leaf) / learned;
        leaf.probability = probability;
    }
    set_probabilities();
}

namespace {

/// A node's lower share in single precision, and never so that the upper one, 1 less it, comes out
/// too small: near 1 floats lie 2^-24 apart, as far as upper shares are large.
float rounded_share(double lower) {
    // Shares of 0 and 1 would close what the plain density keeps open.
    constexpr double kLeast = 0x1p-24;
    const auto share = static_cast<float>(std::clamp(lower, kLeast, 1 - kLeast));
    return double(share) > lower && share > 0.5f ? previous(share) : share;
}

}  // namespace

// From the leaves up: children come after their parents.
//
// A leaf's probability is at least plain_share * volume, that of each node therefore too: the
// density is nowhere below plain_share, but for rounding. A share that rounded_share() or its
// complement lessens at all is at least 1/2 and loses 2^-23 of itself, or is rounded as floats are
// (2^-24). That is so at every node, however unlike its children are: a share that would be less is
// raised to 2^-24, which takes no more than that from one near 1. A way to a leaf has no more than
// 4 * 31 nodes (kMostHalvings along each axis), and the density is at least
// plain_share (1 - 124 * 2^-23), where it is asked for as where it is drawn from.
void PrimaryTree::set_probabilities() {
    probabilities_.assign(nodes_.size(), 0.0);
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        Node& node = nodes_[i];
        if (node.is_leaf()) {
            probabilities_[i] = leaves_[node.target()].probability;
            continue;
        }
        const double lower = probabilities_[node.target()];
        probabilities_[i] = lower + probabilities_[node.target() + 1];
        node.lower_share = rounded_share(lower / probabilities_[i]);
        node.lower_scale = 1 / node.lower_share;
        node.upper_scale = 1 / (1 - node.lower_share);
    }
}

// Where leaves lie follows from the splits, what is expected in them from their sums.
void PrimaryTree::state(StateArchive& archive) {
    const auto halve = [&](std::uint32_t node, unsigned axis) {
        if (!archive.restoring()) return;
        StateArchive::check(leaves_[nodes_[node].target()].side[axis] > kMinSide,
                            "a leaf of an emission tree that is too small");
        split(node, axis);
    };
    state_of_splits(archive, nodes_, 1, kLeafAxis, settings_.max_leaves - 1, halve);
    for (Leaf& leaf : leaves_) {
        for (double* sum : {&leaf.paths, &leaf.score, &leaf.drawn, &leaf.cost})
            archive.amount(*sum);
        for (Sums* sums : {&leaf.root, &leaf.seeds, &leaf.met})
            sums->state(archive);
    }
    if (archive.restoring()) set_expectations();
}

double PrimaryTree::mass() const {
    double sum = 0;
    for (const Leaf& leaf : leaves_)
        sum += leaf_mass(leaf);
    return sum;
}

double PrimaryTree::volume_below(double density) const {
    double sum = 0;
    for (const Leaf& leaf : leaves_)
        sum += leaf.probability < density * leaf.volume ? leaf.volume : 0;
    return sum;
}

std::size_t PrimaryTree::memory_bytes() const {
    return nodes_.capacity() * sizeof(Node) + leaves_.capacity() * sizeof(Leaf) +
           totals_.capacity() * sizeof(Totals) + means_.capacity() * sizeof(Means) +
           probabilities_.capacity() * sizeof(double);
}

std::size_t PrimaryTree::memory_bound_bytes(const PrimaryTreeSettings& settings) {
    return (2 * std::size_t(settings.max_leaves) - 1) *
               (sizeof(Node) + sizeof(Totals) + sizeof(Means) + sizeof(double)) +
           std::size_t(settings.max_leaves) * sizeof(Leaf);
}

}  // namespace aips
