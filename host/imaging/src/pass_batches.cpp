// Which passes make a batch, and how much each batch tells of the variance of a weighted mean.
#include "pass_batches.h"

#include <cmath>

namespace lxs {
namespace {

/// Passes of the first batch. Unit: passes. Balances: what is learnt of two passes against their
/// having been sampled to complement each other, by which their difference overstates. Chosen by:
/// the ratio to the true error after 10 passes, 1.21 with 1, 1.09 with 2, 1.01 with 4.
constexpr std::uint64_t kFirstBatch = 2;

/// Least length of a later batch as share of the passes before it. Unit: 1. Balances: longer
/// batches, in which stratified passes complement each other, against the number of batches, by
/// which the variance of a pixel is known to sqrt(2 / 8). Chosen by: the same figures, 1/8, 1/4 and
/// 1/2.
constexpr double kBatchShare = 0.25;

constexpr std::array<std::array<std::size_t, 2>, 3> kPairs{{{0, 0}, {0, 1}, {1, 1}}};

double over(double a, double b) {
    return b > 0 ? a / b : 0;
}

}  // namespace

void PassBatches::end_pass(const PairOfWeights& weights) {
    ++open_.passes;
    for (std::size_t i = 0; i < weights.size(); ++i)
        open_.sum[i] += weights[i];
    for (std::size_t p = 0; p < kPairs.size(); ++p)
        open_.products[p] += weights[kPairs[p][0]] * weights[kPairs[p][1]];
}

bool PassBatches::full() const {
    if (closed_.passes == 0) return open_.passes >= kFirstBatch;
    return static_cast<double>(open_.passes) >= kBatchShare * static_cast<double>(closed_.passes);
}

PerPair PassBatches::trust() const {
    PerPair trust{};
    for (std::size_t p = 0; p < kPairs.size(); ++p) {
        const auto [i, j] = kPairs[p];
        const double of_open = over(open_.products[p], open_.sum[i] * open_.sum[j]);
        const double before = over(closed_.products[p], closed_.sum[i] * closed_.sum[j]);
        if (before > 0) trust[p] = over(of_open, of_open + before);
    }
    return trust;
}

PerPair PassBatches::told_by_open() const {
    PerPair told{};
    for (std::size_t p = 0; p < told.size(); ++p)
        if (closed_.products[p] > 0) told[p] = open_.products[p];
    return told;
}

PerPair PassBatches::completion() const {
    PerPair completion{};
    const PerPair open = told_by_open();
    for (std::size_t p = 0; p < completion.size(); ++p)
        completion[p] = over(closed_.products[p] + open_.products[p], told_[p] + open[p]);
    return completion;
}

double PassBatches::degrees_of_freedom() const {
    const double open = static_cast<double>(closed_.passes > 0 ? open_.passes : 0);
    const double told = open + told_passes_;
    return over(told * told, squares_told_ + open * open);
}

void PassBatches::close() {
    const PerPair open = told_by_open();
    if (closed_.passes > 0) {
        const auto length = static_cast<double>(open_.passes);
        told_passes_ += length;
        squares_told_ += length * length;
    }
    for (std::size_t p = 0; p < open.size(); ++p) {
        told_[p] += open[p];
        closed_.products[p] += open_.products[p];
    }
    for (std::size_t i = 0; i < open_.sum.size(); ++i)
        closed_.sum[i] += open_.sum[i];
    closed_.passes += open_.passes;
    open_ = {};
}

void PassBatches::Weights::state(StateArchive& archive) {
    archive.value(passes);
    for (double& weight : sum)
        archive.value(weight);
    for (double& product : products)
        archive.value(product);
}

void PassBatches::state(StateArchive& archive) {
    closed_.state(archive);
    open_.state(archive);
    for (double& told : told_)
        archive.value(told);
    archive.value(told_passes_);
    archive.value(squares_told_);
    if (!archive.restoring()) return;
    bool sound = told_passes_ >= 0 && squares_told_ >= 0 && std::isfinite(squares_told_);
    const auto check = [&sound](double value) { sound &= std::isfinite(value) && value >= 0; };
    for (const Weights* weights : {&closed_, &open_}) {
        for (const double sum : weights->sum)
            check(sum);
        for (const double product : weights->products)
            check(product);
    }
    for (const double told : told_)
        check(told);
    if (!sound) throw StateError("a weight of the error's batches is no possible one");
}

}  // namespace lxs
