// Which half of the passes a pass belongs to, and both halves' means.
#include "pass_halves.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "finite_float.h"
#include "for_pixels.h"

namespace lxs {
namespace {

/// Length of a batch as share of the passes before it. Unit: 1. Balances: longer batches, whose
/// passes complement each other as those of the whole render do, against their number, on which a
/// variance rests. Chosen by: eight batches of each half after 30 passes, 16 after 300.
constexpr std::uint64_t kBatchesBefore = 8;

}  // namespace

bool HalvesSchedule::full() const {
    const std::uint64_t before = passes_[0] + passes_[1];
    // Pairs of passes begin where the pairs of their sequence do.
    const std::uint64_t length = before < kBatchesBefore ? 1 : 2 * (1 + before / 32);
    return open_ >= length;
}

void HalvesSchedule::close() {
    const std::size_t to = half();
    if (passes_[to] == 0) first_[to] = open_;
    passes_[to] += open_;
    open_ = 0;
    ++batches_;
}

std::size_t HalvesSchedule::half() const {
    return static_cast<std::size_t>(std::popcount(batches_)) % 2;
}

void HalvesSchedule::state(StateArchive& archive) {
    archive.value(batches_);
    archive.value(open_);
    for (std::size_t h = 0; h < 2; ++h) {
        archive.value(passes_[h]);
        archive.value(first_[h]);
        if (first_[h] > passes_[h]) throw StateError("batches of the film's halves do not fit");
    }
}

void HalfMeans::add(Sums& sums, const PixelMeans& now, std::size_t part, std::size_t half) {
    const double weight = now.weight[part];
    const auto move = [&](float& all, float& first, double to) {
        if (half == 0) first = finite_float(double{first} + to - double{all});
        all = finite_float(to);
    };
    for (int c = 0; c < 3; ++c) {
        const auto i = static_cast<std::size_t>(c);
        move(sums.all.color[i], sums.first_half.color[i], weight * now.value[part][c]);
    }
    move(sums.all.weight, sums.first_half.weight, weight);
}

void HalfMeans::end_batch(const Means& means, bool has_second, std::size_t half) {
    if (has_second) second_.resize(sums_.size());
    for_pixels(sums_.size(), [&](std::size_t i) {
        const PixelMeans now = means(i);
        add(sums_[i], now, 0, half);
        if (!second_.empty()) add(second_[i], now, 1, half);
    });
}

Imath::V3d HalfMeans::mean(const Sums& sums, std::size_t half) {
    Imath::V3d mean(0.0);
    const auto of_half = [half](float all, float first) {
        return half == 0 ? double{first} : double{all} - double{first};
    };
    const double weight = of_half(sums.all.weight, sums.first_half.weight);
    // Lobes of a filter may leave a few passes next to no weight: what they say is nothing.
    constexpr double kLeastShare = 1e-3;
    if (!(weight > kLeastShare * double{sums.all.weight})) return mean;
    for (int c = 0; c < 3; ++c) {
        const auto i = static_cast<std::size_t>(c);
        mean[c] = of_half(sums.all.color[i], sums.first_half.color[i]) / weight;
    }
    return mean;
}

Imath::V3d HalfMeans::mean(std::size_t half, std::size_t pixel) const {
    const Imath::V3d first = mean(sums_[pixel], half);
    return second_.empty() ? first : first + mean(second_[pixel], half);
}

void HalfMeans::clear() {
    std::fill(sums_.begin(), sums_.end(), Sums{});
    std::fill(second_.begin(), second_.end(), Sums{});
}

void HalfMeans::state(StateArchive& archive) {
    // All of their bytes are floats, checked below.
    static_assert(sizeof(Sums) == 8 * sizeof(float));
    std::uint64_t pixels = sums_.size();
    archive.value(pixels);
    if (pixels != sums_.size()) throw StateError("halves are of a film of another size");
    archive.bytes(std::as_writable_bytes(std::span(sums_)));
    bool has_second = !second_.empty();
    archive.value(has_second);
    if (has_second) {
        second_.resize(sums_.size());
        archive.bytes(std::as_writable_bytes(std::span(second_)));
    } else if (archive.restoring()) {
        second_.clear();
    }
    const auto finite = [](const Sum& sum) {
        return std::isfinite(sum.weight) && std::all_of(sum.color.begin(), sum.color.end(),
                                                        [](float v) { return std::isfinite(v); });
    };
    const auto sound = [&](const std::vector<Sums>& all) {
        return std::all_of(all.begin(), all.end(),
                           [&](const Sums& s) { return finite(s.all) && finite(s.first_half); });
    };
    if (!sound(sums_) || !sound(second_))
        throw StateError("a sum of the film's halves is no finite number");
}

std::size_t HalfMeans::memory_bytes() const {
    return (sums_.capacity() + second_.capacity()) * sizeof(Sums);
}

}  // namespace lxs
