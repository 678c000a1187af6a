// Learning directions, and where guiding them pays.
#include "aips/core/tables/bounce_tables.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tables/polya_square.h"

namespace aips {
namespace {

/// Photons that a leaf must have met before it has a density of directions (effective photons).
constexpr double kLeastKnown = 8;

/// Share of a leaf's sum that must be new before its density is made anew.
constexpr double kFreshShare = 0.125;

void check(const BounceTableSettings& s) {
    if (!(s.prior_count > 0)) throw std::invalid_argument("BounceTables: prior_count must be > 0");
    if (!(s.moment_paths > 0))
        throw std::invalid_argument("BounceTables: moment_paths must be > 0");
}

bool usable(const BounceScore& s) {
    return s.power > 0 && std::isfinite(s.power) && s.drawn > 0 && std::isfinite(s.drawn) &&
           std::isfinite(s.plain) && s.score >= 0 && s.cost >= 0 && is_finite(s.direction);
}

}  // namespace

BounceTables::BounceTables(const Bounds& scene, const BounceTableSettings& settings)
    : settings_(settings), places_(scene, settings.places) {
    check(settings);
    const std::uint32_t most = settings.places.max_leaves;
    leaves_.reserve(most);
    in_use_.reserve(most);
    leaf_marks_.reserve(most);
    marks_.reserve(2 * std::size_t(most));
    add_leaves();
    use_tables();
}

bool BounceTables::add(const BounceScore& s) {
    if (!usable(s)) return false;
    double weight = 1;
    if (s.score == 0) {
        if (worthless_++ % kWorthlessOneOf != 0) return true;
        weight = kWorthlessOneOf;
    }
    const double squared = s.score / (s.power * s.power);
    if (!places_.add({s.position, s.normal, squared, weight * s.cost})) return false;
    Leaf& leaf = leaves_[places_.leaf_at(s.position, s.normal)];
    const Frame frame = Frame::world_aligned(s.normal);
    const float cosine = dot(s.direction, s.normal);
    const bool reflected = cosine > 0;
    const std::size_t cell =
        reflected ? cell_index(cosine_square_point(frame, s.direction), kResolution) : 0;
    // Judged before it is learned from: with the density made of earlier ones.
    if (leaf.known) {
        const double table = reflected ? double(leaf.density[cell] * cosine * kInvPi) : 0;
        leaf.moments.add(s.score, s.cost, {s.drawn, s.plain, table}, weight);
    }
    if (!reflected || !(squared > 0)) return true;
    const double root = std::sqrt(squared);
    leaf.sums[cell] += root;
    leaf.sum += root;
    leaf.squares += squared;
    leaf.fresh += root;
    return true;
}

void BounceTables::update(double paths) {
    places_.update(paths);
    add_leaves();
    forget(paths);
    for (Leaf& leaf : leaves_)
        make_density(leaf);
    choose_shares();
    use_tables();
}

// A split leaf's halves both start with its table and half of what it knew.
void BounceTables::add_leaves() {
    for (auto i = std::uint32_t(leaves_.size()); i < places_.leaf_count(); ++i) {
        Leaf child;
        if (const std::uint32_t parent = places_.parent_of(i); parent != i) {
            Leaf& from = leaves_[parent];
            for (double& sum : from.sums)
                sum *= 0.5;
            from.sum *= 0.5;
            from.squares *= 0.5;
            from.fresh *= 0.5;
            from.moments.scale(0.5);
            child.sums = from.sums;
            child.sum = from.sum;
            child.squares = from.squares;
            child.fresh = from.fresh;
            child.density = from.density;
            child.known = from.known;
            child.moments = from.moments;
            child.share = from.share;
        }
        leaves_.push_back(std::move(child));
    }
    in_use_.resize(leaves_.size());
    leaf_marks_.resize(leaves_.size());
}

void BounceTables::forget(double paths) {
    const double moments = settings_.moment_paths / (settings_.moment_paths + paths);
    paths_ += paths;
    const double kept = std::min(1.0, settings_.places.memory_paths / std::max(paths_, 1.0));
    if (kept < 1) paths_ = settings_.places.memory_paths;
    for (Leaf& leaf : leaves_)
        leaf.moments.scale(moments);
    if (kept < 1) keep(kept);
}

/// This share of what tables are made of.
void BounceTables::keep(double share) {
    for (Leaf& leaf : leaves_) {
        for (double& sum : leaf.sums)
            sum *= share;
        leaf.sum *= share;
        leaf.squares *= share;
        leaf.fresh *= share;
    }
}

void BounceTables::fade(double paths) {
    places_.fade(paths);
    if (paths_ <= paths) return;
    const double kept = paths / paths_;
    paths_ = paths;
    keep(kept);
    for (Leaf& leaf : leaves_)
        leaf.moments.scale(kept);
}

void BounceTables::make_density(Leaf& leaf) const {
    if (!(leaf.fresh > kFreshShare * leaf.sum)) return;
    const double effective = leaf.sum * leaf.sum / leaf.squares;
    if (effective < kLeastKnown) return;
    const double prior = settings_.prior_count * leaf.sum / effective;
    polya_density<kResolution>(leaf.sums, prior, leaf.density);
    leaf.fresh = 0;
    leaf.known = true;
    if (leaf.table) leaf.table->build(leaf.density);
}

void BounceTables::choose_shares() {
    everywhere_ = {};
    for (const Leaf& leaf : leaves_)
        everywhere_.add(leaf.moments);
    for (Leaf& leaf : leaves_) {
        if (!leaf.known) continue;
        leaf.share = choose_share(leaf.moments, everywhere_, leaf.share, settings_.shares);
    }
}

void BounceTables::use_tables() {
    tables_in_use_ = 0;
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
        Leaf& leaf = leaves_[i];
        const bool used = leaf.share > 0;
        leaf_marks_[i] = used ? 1 : 0;
        tables_in_use_ += leaf_marks_[i];
        if (!used) {
            leaf.table.reset();
        } else if (!leaf.table) {
            leaf.table = std::make_unique<DirectionalTable>(kResolution);
            leaf.table->build(leaf.density);
        }
        in_use_[i] = {leaf.table.get(), float(kTableShares[leaf.share])};
    }
    places_.mark_branches(leaf_marks_, marks_);
}

void BounceTables::Leaf::state(StateArchive& archive) {
    archive.amounts(sums);
    archive.amounts(density);
    for (double* part : {&sum, &squares, &fresh})
        archive.amount(*part);
    archive.value(known);
    moments.state(archive);
    auto number = static_cast<std::uint8_t>(share);
    archive.value(number);
    StateArchive::check(number < kTableShares.size() && (known || number == 0),
                        "an unknown share of a table of directions");
    share = number;
}

// The tables themselves are made from the densities.
void BounceTables::state(StateArchive& archive) {
    places_.state(archive);
    archive.amount(paths_);
    archive.value(worthless_);
    if (archive.restoring()) add_leaves();
    for (Leaf& leaf : leaves_)
        leaf.state(archive);
    if (archive.restoring()) use_tables();
}

double BounceTables::gain() const {
    double without = 0, with = 0;
    for (const Leaf& leaf : leaves_) {
        without += leaf.moments.moment(0);
        with += leaf.moments.moment(leaf.share);
    }
    return with > 0 ? without / with : 1;
}

std::size_t BounceTables::memory_bytes() const {
    return places_.memory_bytes() + leaves_.capacity() * sizeof(Leaf) +
           in_use_.capacity() * sizeof(BounceTable) + marks_.capacity() + leaf_marks_.capacity() +
           tables_in_use_ * DirectionalTable::memory_bytes(kResolution);
}

std::size_t BounceTables::memory_bound_bytes(const BounceTableSettings& settings) {
    const std::size_t leaf =
        sizeof(Leaf) + sizeof(BounceTable) + 3 + DirectionalTable::memory_bytes(kResolution);
    return ScoreCache::memory_bound_bytes(settings.places) + settings.places.max_leaves * leaf;
}

}  // namespace aips
