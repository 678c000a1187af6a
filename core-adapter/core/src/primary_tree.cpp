// Learning and sampling of a density over primary coordinates.
#include "aips/core/primary_tree.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "aips/core/sampling.h"

namespace aips {
namespace {

constexpr std::uint32_t kMaxLeaves = 1u << 24;
/// Sides below this would outrun the 24 bits of a random number.
constexpr float kMinSide = 0x1p-20f;
/// Share of its history that a new leaf keeps: how the score lay within the half is a guess.
constexpr double kInherited = 0.1;

void check(const PrimaryTreeSettings& s) {
    if (s.max_leaves < 1 || s.max_leaves > kMaxLeaves) {
        throw std::invalid_argument("PrimaryTree: max_leaves must be in [1, 2^24]");
    }
    if (s.split_count < 1) throw std::invalid_argument("PrimaryTree: split_count must be positive");
    if (!(s.split_gain >= 0)) throw std::invalid_argument("PrimaryTree: split_gain is negative");
    if (!(s.memory_paths > 0)) throw std::invalid_argument("PrimaryTree: memory_paths must be > 0");
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
    nodes_.reserve(2 * std::size_t(settings.max_leaves) - 1);
    leaves_.reserve(settings.max_leaves);
    nodes_.push_back({});
    leaves_.push_back({});
}

PrimarySample PrimaryTree::sample(const PrimaryPoint& u) const {
    std::array<double, 4> within;
    std::copy(u.begin(), u.end(), within.begin());
    std::uint32_t i = 0;
    while (nodes_[i].axis != kLeafAxis) {
        const Node& node = nodes_[i];
        double& x = within[node.axis];
        const bool lower = x < node.lower_share;
        x = lower ? x / node.lower_share : (x - node.lower_share) / (1 - node.lower_share);
        i = node.first + (lower ? 0u : 1u);
    }
    const Leaf& leaf = leaves_[nodes_[i].first];
    PrimarySample sample;
    for (unsigned axis = 0; axis < 4; ++axis) {
        // Rounding must not move the point out of the leaf, where pdf() finds another density.
        const float end = std::nextafter(leaf.corner[axis] + leaf.side[axis], 0.0f);
        const auto x =
            static_cast<float>(double(leaf.corner[axis]) + within[axis] * double(leaf.side[axis]));
        sample.point[axis] = std::clamp(x, leaf.corner[axis], end);
    }
    sample.pdf = static_cast<float>(leaf.pdf);
    return sample;
}

std::uint32_t PrimaryTree::locate(const PrimaryPoint& point) const {
    std::array<float, 4> low{}, side{1, 1, 1, 1};
    std::uint32_t i = 0;
    while (nodes_[i].axis != kLeafAxis) {
        const unsigned axis = nodes_[i].axis;
        side[axis] *= 0.5f;
        const bool upper = point[axis] >= low[axis] + side[axis];
        if (upper) low[axis] += side[axis];
        i = nodes_[i].first + (upper ? 1u : 0u);
    }
    return nodes_[i].first;
}

float PrimaryTree::pdf(const PrimaryPoint& point) const {
    return static_cast<float>(leaves_[locate(point)].pdf);
}

std::array<bool, 4> PrimaryTree::lower_halves(const Leaf& leaf, const PrimaryPoint& point) const {
    std::array<bool, 4> lower{};
    for (unsigned axis = 0; axis < 4; ++axis)
        lower[axis] = point[axis] < leaf.corner[axis] + 0.5f * leaf.side[axis];
    return lower;
}

void PrimaryTree::add(const PrimaryPoint& point, double pdf, double score) {
    const double value = score * pdf;
    if (!(value > 0) || !std::isfinite(value)) return;
    Leaf& leaf = leaves_[locate(point)];
    const auto lower = lower_halves(leaf, point);
    leaf.score.add(lower, value);
    leaf.met.add(lower, 1);
}

void PrimaryTree::add_seed(const PrimaryPoint& point, double weight) {
    if (!(weight > 0) || !std::isfinite(weight)) return;
    Leaf& leaf = leaves_[locate(point)];
    const auto lower = lower_halves(leaf, point);
    leaf.seeds.add(lower, weight);
    leaf.met.add(lower, 1);
}

void PrimaryTree::update(double paths) {
    for (Leaf& leaf : leaves_) {
        leaf.paths += std::max(0.0, paths);
        if (leaf.paths > settings_.memory_paths) {
            leaf.score.scale(settings_.memory_paths / leaf.paths);
            leaf.paths = settings_.memory_paths;
        }
    }
    split_leaves();
}

double PrimaryTree::leaf_mass(const Leaf& leaf) const {
    return leaf.paths > 0 ? std::sqrt(leaf.score.whole * leaf.volume / leaf.paths) : 0;
}

/// Fall of the learned mass, and of the seeds' like measure, as shares of the whole tree's. For
/// seeds the mass is sqrt(count^2) = count whatever the split; what falls is the volume that their
/// density is spread over, which the root of (count * volume) measures.
double PrimaryTree::split_gain(const Leaf& leaf, unsigned axis, double mass, double seeds) const {
    const auto fall = [&](const Sums& sums) {
        const double lower = sums.lower[axis];
        const double upper = std::max(0.0, sums.whole - lower);
        return std::sqrt(sums.whole * leaf.volume) -
               std::sqrt(0.5 * leaf.volume) * (std::sqrt(lower) + std::sqrt(upper));
    };
    const double learned = mass > 0 ? fall(leaf.score) / std::sqrt(leaf.paths) / mass : 0;
    return std::max(learned, seeds > 0 ? fall(leaf.seeds) / seeds : 0.0);
}

// Greedy, one level at each call and leaf: the sums of new leaves are first to be learned anew.
void PrimaryTree::split_leaves() {
    double seeds = 0;
    for (const Leaf& leaf : leaves_)
        seeds += std::sqrt(leaf.seeds.whole * leaf.volume);
    const double whole_mass = mass();
    struct Candidate {
        double gain;
        std::uint32_t node;
        unsigned axis;
    };
    std::vector<Candidate> candidates;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i].axis != kLeafAxis) continue;
        const Leaf& leaf = leaves_[nodes_[i].first];
        if (leaf.met.whole < settings_.split_count) continue;
        Candidate best{settings_.split_gain, i, kLeafAxis};
        for (unsigned axis = 0; axis < 4; ++axis) {
            if (leaf.side[axis] <= kMinSide) continue;
            const double gain = split_gain(leaf, axis, whole_mass, seeds);
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
    const std::uint32_t lower = nodes_[node].first;
    const auto upper = static_cast<std::uint32_t>(leaves_.size());
    const Leaf whole = leaves_[lower];
    leaves_.push_back(whole);
    for (const bool is_upper : {false, true}) {
        Leaf& leaf = leaves_[is_upper ? upper : lower];
        leaf.side[axis] *= 0.5f;
        leaf.volume *= 0.5;
        if (is_upper) leaf.corner[axis] += leaf.side[axis];
        leaf.score = whole.score.half(axis, is_upper);
        leaf.seeds = whole.seeds.half(axis, is_upper);
        leaf.score.scale(kInherited);
        leaf.paths *= kInherited;
        leaf.met = {};
    }
    const auto child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({.first = lower});
    nodes_.push_back({.first = upper});
    nodes_[node] = {.axis = axis, .first = child};
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
        leaf.pdf = probability / leaf.volume;
    }
    set_probabilities();
}

// From the leaves up: children come after their parents.
void PrimaryTree::set_probabilities() {
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        Node& node = nodes_[i];
        if (node.axis == kLeafAxis) {
            node.probability = leaves_[node.first].pdf * leaves_[node.first].volume;
            continue;
        }
        const double lower = nodes_[node.first].probability;
        node.probability = lower + nodes_[node.first + 1].probability;
        node.lower_share = lower / node.probability;
    }
}

double PrimaryTree::mass() const {
    double sum = 0;
    for (const Leaf& leaf : leaves_)
        sum += leaf_mass(leaf);
    return sum;
}

std::size_t PrimaryTree::memory_bytes() const {
    return nodes_.capacity() * sizeof(Node) + leaves_.capacity() * sizeof(Leaf);
}

std::size_t PrimaryTree::memory_bound_bytes(const PrimaryTreeSettings& settings) {
    return (2 * std::size_t(settings.max_leaves) - 1) * sizeof(Node) +
           std::size_t(settings.max_leaves) * sizeof(Leaf);
}

}  // namespace aips
