// Learning what photons contribute, and what they cost, where they scatter.
#include "aips/core/trees/score_cache.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "aips/core/base/constants.h"
#include "trees/split_order.h"
#include "trees/usable_bounds.h"

namespace aips {
namespace {

/// Least side of a leaf of places (share of the scene's longest side).
constexpr float kLeastSideShare = 0x1p-12f;

void check(const ScoreCacheSettings& s) {
    if (s.max_leaves < 6 || s.max_leaves > kMostLeaves) {
        throw std::invalid_argument("ScoreCache: max_leaves must be in [6, 2^24]");
    }
    if (s.split_count < 4) throw std::invalid_argument("ScoreCache: split_count must be >= 4");
    if (!(s.split_gain >= 0)) throw std::invalid_argument("ScoreCache: split_gain is negative");
    if (!(s.split_mass > 0)) throw std::invalid_argument("ScoreCache: split_mass must be > 0");
    if (!(s.memory_paths > 0)) throw std::invalid_argument("ScoreCache: memory_paths must be > 0");
    if (!(s.prior_count > 0) || !std::isfinite(s.prior_count)) {
        throw std::invalid_argument("ScoreCache: prior_count must be > 0 and finite");
    }
}

/// In [0, the greatest float]; false for NaN.
bool representable(double value) {
    return value >= 0 && value <= double(std::numeric_limits<float>::max());
}

}  // namespace

void ScoreCache::Totals::add(const Totals& other) {
    count += other.count;
    scored += other.scored;
    root += other.root;
    score += other.score;
    cost += other.cost;
}

void ScoreCache::Totals::scale(double factor) {
    count *= factor;
    scored *= factor;
    root *= factor;
    score *= factor;
    cost *= factor;
}

ScoreCache::Means ScoreCache::Totals::blend(Means prior, double prior_weight) const {
    const double weight = count + prior_weight;
    return {static_cast<float>((score + prior_weight * double(prior.score)) / weight),
            static_cast<float>((cost + prior_weight * double(prior.cost)) / weight)};
}

void ScoreCache::HalfSums::add(const std::array<bool, 3>& is_lower, double value) {
    whole += value;
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (is_lower[axis]) lower[axis] += value;
    }
}

void ScoreCache::HalfSums::add(const HalfSums& other) {
    whole += other.whole;
    for (unsigned axis = 0; axis < 3; ++axis)
        lower[axis] += other.lower[axis];
}

void ScoreCache::HalfSums::scale(double factor) {
    whole *= factor;
    for (double& sum : lower)
        sum *= factor;
}

double ScoreCache::HalfSums::half(int axis, bool upper) const {
    const double below = lower[unsigned(axis)];
    return upper ? std::max(0.0, whole - below) : below;
}

void ScoreCache::Probe::add(const Probe& other) {
    count.add(other.count);
    scored.add(other.scored);
    root.add(other.root);
    score.add(other.score);
    cost.add(other.cost);
}

void ScoreCache::Probe::scale(double factor) {
    for (HalfSums* sums : {&count, &scored, &root, &score, &cost})
        sums->scale(factor);
}

ScoreCache::Totals ScoreCache::Probe::whole() const {
    return {count.whole, scored.whole, root.whole, score.whole, cost.whole};
}

ScoreCache::Totals ScoreCache::Probe::half(int axis, bool upper) const {
    return {count.half(axis, upper), scored.half(axis, upper), root.half(axis, upper),
            score.half(axis, upper), cost.half(axis, upper)};
}

/// Fall of sqrt(S C) by a split, as a share of it: >= 0 by Cauchy and Schwarz, and 0 only if the
/// halves' scores are as their costs.
double ScoreCache::Probe::gain(int axis) const {
    const double whole = std::sqrt(score.whole * cost.whole);
    if (!(whole > 0)) return 0;
    double halves = 0;
    for (const bool upper : {false, true})
        halves += std::sqrt(score.half(axis, upper) * cost.half(axis, upper));
    return std::max(0.0, 1 - halves / whole);
}

/// Whether more vertices have a score in one half than by chance. Scores' sizes, which are uneven,
/// are slower to tell.
bool ScoreCache::Probe::shares_differ(int axis) const {
    const double share = scored.whole / count.whole;
    double difference = 0, variance = 0;
    for (const bool upper : {false, true}) {
        const Totals sums = half(axis, upper);
        if (sums.count < 2) return false;
        difference += (upper ? 1 : -1) * sums.scored / sums.count;
        variance += share * (1 - share) / sums.count;
    }
    return difference * difference > kSureErrors * kSureErrors * variance;
}

bool ScoreCache::Probe::halves_differ(int axis) const {
    if (shares_differ(axis)) return true;
    double difference = 0, variance = 0;
    for (const bool upper : {false, true}) {
        const Totals sums = half(axis, upper);
        if (sums.count < 2) return false;
        const double mean = sums.root / sums.count;
        difference += upper ? mean : -mean;
        variance += std::max(0.0, sums.score / sums.count - mean * mean) / (sums.count - 1);
    }
    return difference * difference > kSureErrors * kSureErrors * variance;
}

ScoreCache::ScoreCache(const Bounds& scene, const ScoreCacheSettings& settings)
    : settings_(settings) {
    check(settings);
    const Bounds box = usable_bounds(scene);
    const Vec3 extent = box.extent();
    min_side_ = kLeastSideShare * std::max({extent.x, extent.y, extent.z});
    const std::size_t branches = 2 * std::size_t(settings.max_leaves) - kTrees;
    branches_.reserve(branches);
    means_.reserve(branches);
    totals_.reserve(branches);
    leaves_.reserve(settings.max_leaves);
    for (std::uint32_t tree = 0; tree < kTrees; ++tree) {
        branches_.push_back({0, tree * 4 + kLeaf});
        Leaf& leaf = leaves_.emplace_back();
        leaf.box = box;
        leaf.parent = tree;
    }
    means_.resize(kTrees);
    totals_.resize(kTrees);
}

bool ScoreCache::usable(const VertexScore& vertex) {
    return is_finite(vertex.position) && is_finite(vertex.normal) && representable(vertex.score) &&
           representable(vertex.cost);
}

bool ScoreCache::add(const VertexScore& vertex) {
    if (!usable(vertex)) return false;
    add_at(locate(vertex.position, vertex.normal), vertex);
    return true;
}

void ScoreCache::add_at(std::uint32_t branch, const VertexScore& vertex) {
    Leaf& leaf = leaves_[branches_[branch].target()];
    add(totals_[branch], leaf.met, leaf.probe, leaf.box, vertex);
}

void ScoreCache::add_to(Sums& sums, std::uint32_t branch, const VertexScore& vertex) const {
    add(sums.totals, sums.met, sums.probe, leaves_[branches_[branch].target()].box, vertex);
}

void ScoreCache::add_at(std::uint32_t branch, const Sums& sums) {
    totals_[branch].add(sums.totals);
    Leaf& leaf = leaves_[branches_[branch].target()];
    leaf.met.extend(sums.met);
    leaf.probe.add(sums.probe);
}

void ScoreCache::add(Totals& totals, Bounds& met, Probe& probe, const Bounds& box,
                     const VertexScore& vertex) {
    const double root = std::sqrt(vertex.score);
    const double scored = vertex.score > 0 ? 1 : 0;
    totals.add({1, scored, root, vertex.score, vertex.cost});
    std::array<bool, 3> lower{};
    for (int axis = 0; axis < 3; ++axis)
        lower[unsigned(axis)] = vertex.position[axis] < halving_plane(box, axis);
    met.extend(vertex.position);
    probe.count.add(lower, 1);
    probe.scored.add(lower, scored);
    probe.root.add(lower, root);
    probe.score.add(lower, vertex.score);
    probe.cost.add(lower, vertex.cost);
}

void ScoreCache::update(double paths) {
    paths_ += std::max(0.0, paths);
    forget(settings_.memory_paths);
    split_leaves();
    add_totals();
    set_means();
}

void ScoreCache::fade(double paths) {
    forget(paths);
    add_totals();
    set_means();
}

void ScoreCache::forget(double most) {
    if (paths_ <= most) return;
    const double kept = most / paths_;
    paths_ = most;
    for (Totals& totals : totals_)
        totals.scale(kept);
    for (Leaf& leaf : leaves_)
        leaf.probe.scale(kept);
}

void ScoreCache::add_totals() {
    for (std::size_t i = branches_.size(); i-- > 0;) {
        if (branches_[i].axis() == kLeaf) continue;
        totals_[i] = totals_[branches_[i].target()];
        totals_[i].add(totals_[branches_[i].target() + 1]);
    }
}

/// In vertices: as many of the parent's as have prior_count with a score among them.
double ScoreCache::prior_weight(const Totals& parent) const {
    return settings_.prior_count * (parent.scored > 0 ? parent.count / parent.scored : 1);
}

// From the roots down: the prior of a node is its parent.
void ScoreCache::set_means() {
    Totals whole;
    for (std::uint32_t tree = 0; tree < kTrees; ++tree)
        whole.add(totals_[tree]);
    if (!(whole.count > 0)) {
        std::fill(means_.begin(), means_.end(), Means{});
        return;
    }
    const Means mean = whole.blend({}, 0);
    for (std::uint32_t tree = 0; tree < kTrees; ++tree)
        means_[tree] = totals_[tree].blend(mean, prior_weight(whole));
    for (std::uint32_t i = 0; i < branches_.size(); ++i) {
        if (branches_[i].axis() == kLeaf) continue;
        for (const std::uint32_t child : {branches_[i].target(), branches_[i].target() + 1})
            means_[child] = totals_[child].blend(means_[i], prior_weight(totals_[i]));
    }
}

// Children come after their parents.
void ScoreCache::mark_branches(std::span<const std::uint8_t> leaf_marks,
                               std::vector<std::uint8_t>& marks) const {
    marks.resize(branches_.size());
    for (std::size_t i = branches_.size(); i-- > 0;) {
        const std::uint32_t target = branches_[i].target();
        const bool is_leaf = branches_[i].axis() == kLeaf;
        const bool marked = is_leaf ? leaf_marks[target] > 0 : marks[target] || marks[target + 1];
        marks[i] = marked ? 1 : 0;
    }
}

std::size_t ScoreCache::memory_bytes() const {
    return branches_.capacity() * (sizeof(Branch) + sizeof(Means) + sizeof(Totals)) +
           leaves_.capacity() * sizeof(Leaf);
}

std::size_t ScoreCache::memory_bound_bytes(const ScoreCacheSettings& settings) {
    return (2 * std::size_t(settings.max_leaves) - kTrees) *
               (sizeof(Branch) + sizeof(Means) + sizeof(Totals)) +
           std::size_t(settings.max_leaves) * sizeof(Leaf);
}

}  // namespace aips
