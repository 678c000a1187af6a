// Learning who carries caustics on glossy lobes.
#include "aips/core/tables/gloss_table.h"

#include "aips/core/base/constants.h"

#include <algorithm>
#include <cmath>

namespace aips {
namespace {

constexpr ScoreCacheSettings kGlossPlaces{.max_leaves = kTableLeaves,
                                          .split_count = kShareSplitPoints,
                                          .memory_paths = 1e15};  // choose() forgets

bool usable(const GlossSample& s) {
    const auto amount = [](double x) { return x >= 0 && std::isfinite(x); };
    return amount(s.weight) && amount(s.light) && amount(s.weight * s.light * s.light) &&
           amount(s.photons) && amount(s.weight * s.photons * s.weight * s.photons) &&
           amount(s.weight * s.bounce);
}

/// Its score: where errors may come from, whoever brings the light.
VertexScore vertex_of(const GlossSample& s) {
    return {s.position, s.normal, s.weight * (s.light * s.light + s.bounce), 1};
}

}  // namespace

void GlossTable::Sums::add(const Sums& other) {
    points += other.points;
    photons += other.photons;
    spread += other.spread;
    bounce += other.bounce;
}

void GlossTable::Sums::scale(double factor) {
    for (double* sum : {&points, &photons, &spread, &bounce})
        *sum *= factor;
}

void GlossTable::Sums::state(StateArchive& archive) {
    for (double* sum : {&points, &photons, &spread, &bounce})
        archive.amount(*sum);
}

// Single photons may be far brighter than all that were met.
bool GlossTable::Sums::photons_pay(const GlossCosts& costs) const {
    const double of_photons = (photons + kSureErrors * std::sqrt(spread)) / costs.photon_paths;
    return of_photons + costs.price * points < bounce;
}

GlossTable::GlossTable(const Bounds& scene) : places_(scene, kGlossPlaces) {
    leaves_.reserve(kGlossPlaces.max_leaves);
    add_leaves();
}

bool GlossTable::add(const GlossSample& s) {
    const VertexScore vertex = vertex_of(s);
    if (!usable(s) || !ScoreCache::usable(vertex)) return false;
    const std::uint32_t branch = places_.branch_at(s.position, s.normal);
    places_.add_at(branch, vertex);
    const double photons = s.weight * s.photons;
    const Sums sums{1, photons, photons * photons, s.weight * s.bounce};
    leaves_[places_.leaf_of(branch)].sums.add(sums);
    everywhere_.add(sums);
    return true;
}

void GlossTable::update(std::size_t samples) {
    places_.update(double(samples));
    add_leaves();
}

// Both halves of a leaf start with half of what it knew.
void GlossTable::add_leaves() {
    for (auto i = std::uint32_t(leaves_.size()); i < places_.leaf_count(); ++i) {
        const std::uint32_t parent = places_.parent_of(i);
        if (parent == i) {
            leaves_.emplace_back();
            continue;
        }
        leaves_[parent].sums.scale(0.5);
        leaves_.push_back(Leaf(leaves_[parent]));
    }
}

void GlossTable::choose(const GlossCosts& costs, double memory) {
    Sums prior = everywhere_;
    prior.scale(prior.points > 0 ? std::min(1.0, kSharePrior / prior.points) : 0);
    for (Leaf& leaf : leaves_) {
        Sums sums = leaf.sums;
        sums.add(prior);
        if (sums.points > 0 && costs.photon_paths > 0) leaf.by_photons = sums.photons_pay(costs);
        leaf.sums.scale(memory);
    }
    everywhere_.scale(memory);
}

void GlossTable::state(StateArchive& archive) {
    places_.state(archive);
    if (archive.restoring()) leaves_.assign(places_.leaf_count(), {});
    everywhere_.state(archive);
    for (Leaf& leaf : leaves_) {
        leaf.sums.state(archive);
        archive.value(leaf.by_photons);
    }
}

std::size_t GlossTable::memory_bytes() const {
    return places_.memory_bytes() + leaves_.capacity() * sizeof(Leaf);
}

std::size_t GlossTable::memory_bound_bytes() {
    return ScoreCache::memory_bound_bytes(kGlossPlaces) + kGlossPlaces.max_leaves * sizeof(Leaf);
}

}  // namespace aips
