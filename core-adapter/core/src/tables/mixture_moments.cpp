// Second moments of mixtures, and the choice between them.
#include "aips/core/tables/mixture_moments.h"

#include <cmath>

namespace aips {

void MixtureMoments::add(double score, double cost, const DirectionDensities& p, double weight) {
    if (!(p.plain > 0) || !(p.drawn > 0)) return;
    const double plain = score * p.drawn / p.plain;
    // Sums that have once been infinite would stay so.
    if (!std::isfinite(plain * plain) || !std::isfinite(cost)) return;
    for (std::size_t i = 0; i < kTableShares.size(); ++i) {
        const double a = kTableShares[i];
        const double mixed = (1 - a) * p.plain + a * p.table;
        moments_[i] += weight * score * p.drawn / mixed;
        costs_[i] += weight * cost * mixed / p.drawn;
    }
    squares_ += weight * plain * plain;
    count_ += weight;
}

void MixtureMoments::add(const MixtureMoments& other) {
    for (std::size_t i = 0; i < kTableShares.size(); ++i) {
        moments_[i] += other.moments_[i];
        costs_[i] += other.costs_[i];
    }
    squares_ += other.squares_;
    count_ += other.count_;
}

void MixtureMoments::scale(double share) {
    for (std::size_t i = 0; i < kTableShares.size(); ++i) {
        moments_[i] *= share;
        costs_[i] *= share;
    }
    squares_ *= share;
    count_ *= share;
}

void MixtureMoments::state(StateArchive& archive) {
    archive.amounts(moments_);
    archive.amounts(costs_);
    archive.amount(squares_);
    archive.amount(count_);
}

double MixtureMoments::moment_ratio(std::size_t i) const {
    return moments_[0] > 0 ? moments_[i] / moments_[0] : 1;
}

double MixtureMoments::cost_ratio(std::size_t i, double table_cost) const {
    if (!(costs_[0] > 0)) return 1;
    return (costs_[i] + (kTableShares[i] > 0 ? table_cost * count_ : 0)) / costs_[0];
}

double MixtureMoments::effective_count() const {
    return squares_ > 0 ? moments_[0] * moments_[0] / squares_ : 0;
}

std::size_t choose_share(const MixtureMoments& here, const MixtureMoments& everywhere,
                         std::size_t present, const ShareSettings& settings) {
    const double prior = settings.prior_count;
    const double known = here.effective_count(), met = here.count();
    std::size_t best = 0;
    double least = 1;
    for (std::size_t i = 1; i < kTableShares.size(); ++i) {
        const double moment =
            (known * here.moment_ratio(i) + prior * everywhere.moment_ratio(i)) / (known + prior);
        const double cost = (met * here.cost_ratio(i, settings.table_cost) +
                             prior * everywhere.cost_ratio(i, settings.table_cost)) /
                            (met + prior);
        if (moment * cost >= least) continue;
        least = moment * cost;
        best = i;
    }
    return least * (present > 0 ? 1.0 : settings.gain) < 1 ? best : 0;
}

}  // namespace aips
