// Learning which lights light a place.
#include "aips/core/tables/light_tables.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace aips {
namespace {

/// Numbers that all tables of lights together hold at most, a sum and a probability for each light
/// and leaf (entries).
constexpr std::size_t kMostLightEntries = std::size_t{1} << 18;

/// What the halves of a leaf start with at most: what it knew is a prior for them (shadow rays).
constexpr double kInheritedRays = 16;

constexpr std::uint32_t kFewestLeaves = 6;

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

bool usable(const LightSample& s, std::span<const float> plain) {
    return s.light < plain.size() && plain[s.light] > 0 && s.pdf > 0 && s.value >= 0 &&
           std::isfinite(s.value);
}

}  // namespace

LightTableSettings light_table_settings(std::size_t lights) {
    LightTableSettings settings;
    const std::size_t leaves = kMostLightEntries / std::max<std::size_t>(lights, 1);
    settings.places.max_leaves =
        static_cast<std::uint32_t>(std::clamp<std::size_t>(leaves, kFewestLeaves, kTableLeaves));
    return settings;
}

LightTables::LightTables(const Bounds& scene, const DiscreteDistribution& plain,
                         const LightTableSettings& settings)
    : settings_(settings), places_(scene, settings.places), plain_(plain.size()) {
    if (plain.empty()) throw std::invalid_argument("LightTables: no light to choose");
    if (!(settings.plain_share > 0 && settings.plain_share <= 1))
        throw std::invalid_argument("LightTables: plain_share must be in (0, 1]");
    if (!(settings.prior_count > 0))
        throw std::invalid_argument("LightTables: prior_count must be > 0");
    for (std::size_t i = 0; i < plain_.size(); ++i)
        plain_[i] = plain.pdf(i);
    everywhere_.squares.resize(plain_.size());
    leaves_.reserve(settings.places.max_leaves);
    choices_.reserve(settings.places.max_leaves);
    add_leaves();
    make_choices();
}

bool LightTables::add(const LightSample& s) {
    if (!usable(s, plain_)) return false;
    const double square = double(s.value) * double(s.value) / double(s.pdf);
    if (!places_.add({s.position, s.normal, square, 1})) return false;
    for (Sums* sums : {&leaves_[places_.leaf_at(s.position, s.normal)], &everywhere_}) {
        sums->rays += 1;
        sums->squares[s.light] += square;
    }
    return true;
}

void LightTables::update(std::size_t samples) {
    places_.update(double(samples));
    add_leaves();
    make_choices();
}

// Both halves of a leaf start with what it knew, weighing less than what they will meet.
void LightTables::add_leaves() {
    for (auto i = std::uint32_t(leaves_.size()); i < places_.leaf_count(); ++i) {
        const std::uint32_t parent = places_.parent_of(i);
        if (parent == i) {
            leaves_.push_back({0, std::vector<double>(plain_.size())});
            continue;
        }
        Sums& from = leaves_[parent];
        const double kept = std::min(0.5, kInheritedRays / std::max(from.rays, 1.0));
        from.rays *= kept;
        for (double& square : from.squares)
            square *= kept;
        leaves_.push_back(from);
    }
    choices_.resize(leaves_.size());
}

// Of the mean over all places it is the shares of the lights that a place takes for its own: what
// they bring where emitters are near is no measure for a place where all is dim.
void LightTables::make_choices() {
    const std::size_t lights = plain_.size();
    const double everywhere = sum(everywhere_.squares);
    std::vector<double> roots(lights);
    std::vector<float> weights(lights);
    for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf) {
        const Sums& met = leaves_[leaf];
        const double here = sum(met.squares);
        const double of_all = here > 0 ? settings_.prior_count * (here / met.rays) / everywhere : 1;
        double total = 0;
        for (std::size_t i = 0; i < lights; ++i) {
            // Their common divisor, all rays and the prior's, is left out.
            const double square = met.squares[i] + of_all * everywhere_.squares[i];
            roots[i] = plain_[i] > 0 ? std::sqrt(square) : 0;
            total += roots[i];
        }
        const bool known = total > 0 && std::isfinite(total);
        const double share = settings_.plain_share;
        for (std::size_t i = 0; i < lights; ++i) {
            const double plain = double(plain_[i]);
            weights[i] = float(known ? share * plain + (1 - share) * (roots[i] / total) : plain);
        }
        choices_[leaf].build(weights);
    }
}

void LightTables::fade(double rays) {
    places_.fade(rays);
    if (everywhere_.rays <= rays) return;
    const double kept = rays / everywhere_.rays;
    const auto keep = [kept](Sums& sums) {
        sums.rays *= kept;
        for (double& square : sums.squares)
            square *= kept;
    };
    keep(everywhere_);
    for (Sums& sums : leaves_)
        keep(sums);
    make_choices();
}

void LightTables::state(StateArchive& archive) {
    places_.state(archive);
    if (archive.restoring()) {
        leaves_.assign(places_.leaf_count(), {0, std::vector<double>(plain_.size())});
        choices_.resize(leaves_.size());
    }
    const auto sums_of = [&](Sums& sums) {
        archive.amount(sums.rays);
        for (double& square : sums.squares)
            archive.amount(square);
    };
    sums_of(everywhere_);
    for (Sums& sums : leaves_)
        sums_of(sums);
    if (archive.restoring()) make_choices();
}

std::size_t LightTables::memory_bytes() const {
    const std::size_t light = sizeof(double) + sizeof(float);
    return places_.memory_bytes() + leaves_.capacity() * sizeof(Sums) +
           choices_.capacity() * sizeof(DiscreteDistribution) +
           (leaves_.size() + 1) * plain_.size() * light;
}

std::size_t LightTables::memory_bound_bytes(const LightTableSettings& settings,
                                            std::size_t lights) {
    const std::size_t light = sizeof(double) + sizeof(float);
    const std::size_t leaf = sizeof(Sums) + sizeof(DiscreteDistribution) + lights * light;
    return ScoreCache::memory_bound_bytes(settings.places) + settings.places.max_leaves * leaf +
           lights * light;
}

}  // namespace aips
