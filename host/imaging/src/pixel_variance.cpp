// The variance of each pixel's mean over passes, from batches of passes.
#include "pixel_variance.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "finite_float.h"
#include "for_pixels.h"

namespace lxs {
namespace {

constexpr int kColors = 3;

/// What has moved a mean since the last batch, times the weight that it rests on now.
double moved(const PixelMeans& now, std::size_t part, int color, float before) {
    return now.weight[part] * (now.value[part][color] - double{before});
}

}  // namespace

void PixelVariance::end_pass(const FilmAccumulator& film, const PairOfWeights& weights) {
    if (film.has_second()) second_.resize(first_.size());
    batches_.end_pass(weights);
    if (batches_.full()) end_batch(film);
}

void PixelVariance::end_batch(const FilmAccumulator& film) {
    const PerPair trust = batches_.trust();
    for_pixels(first_.size(), [&](std::size_t i) {
        const PixelMeans now = film.means(i);
        First& first = first_[i];
        for (int c = 0; c < kColors; ++c) {
            const double a = moved(now, 0, c, first.mean[c]);
            first.squares[c] = finite_float(first.squares[c] + trust[0] * a * a);
            first.mean[c] = finite_float(now.value[0][c]);
            if (second_.empty()) continue;
            Second& second = second_[i];
            const double b = moved(now, 1, c, second.mean[c]);
            second.products[c] = finite_float(second.products[c] + trust[1] * a * b);
            second.squares[c] = finite_float(second.squares[c] + trust[2] * b * b);
            second.mean[c] = finite_float(now.value[1][c]);
        }
    });
    batches_.close();
}

void PixelVariance::clear() {
    batches_ = {};
    std::fill(first_.begin(), first_.end(), First{});
    std::fill(second_.begin(), second_.end(), Second{});
}

Imath::V3d PixelVariance::variance(std::size_t pixel, const PixelMeans& now) const {
    const PerPair trust = batches_.open_passes() > 0 ? batches_.trust() : PerPair{};
    const PerPair completion = batches_.completion();
    const First& first = first_[pixel];
    const double w0 = now.weight[0], w1 = now.weight[1];
    Imath::V3d variance(0.0);
    for (int c = 0; c < kColors; ++c) {
        const double a = moved(now, 0, c, first.mean[c]);
        double v = 0;
        if (w0 > 0) v = completion[0] * (first.squares[c] + trust[0] * a * a) / (w0 * w0);
        if (!second_.empty() && w1 > 0) {
            const Second& second = second_[pixel];
            const double b = moved(now, 1, c, second.mean[c]);
            v += completion[2] * (second.squares[c] + trust[2] * b * b) / (w1 * w1);
            if (w0 > 0)
                v += 2 * completion[1] * (second.products[c] + trust[1] * a * b) / (w0 * w1);
        }
        variance[c] = std::max(v, 0.0);
    }
    return variance;
}

void PixelVariance::state(StateArchive& archive) {
    batches_.state(archive);
    // All of their bytes are floats, checked below.
    static_assert(sizeof(First) == 6 * sizeof(float) && sizeof(Second) == 9 * sizeof(float));
    std::uint64_t pixels = first_.size();
    archive.value(pixels);
    if (pixels != first_.size()) throw StateError("variances are of a film of another size");
    archive.bytes(std::as_writable_bytes(std::span(first_)));
    bool has_second = !second_.empty();
    archive.value(has_second);
    if (has_second) {
        second_.resize(first_.size());
        archive.bytes(std::as_writable_bytes(std::span(second_)));
    } else if (archive.restoring()) {
        second_.clear();
    }
    if (!archive.restoring()) return;
    const auto finite = [](const Color& color) {
        return std::all_of(color.begin(), color.end(), [](float v) { return std::isfinite(v); });
    };
    const auto sound = [](const Color& squares) {
        return std::all_of(squares.begin(), squares.end(),
                           [](float v) { return std::isfinite(v) && v >= 0; });
    };
    const bool whole =
        std::all_of(first_.begin(), first_.end(),
                    [&](const First& f) { return finite(f.mean) && sound(f.squares); }) &&
        std::all_of(second_.begin(), second_.end(), [&](const Second& s) {
            return finite(s.mean) && finite(s.products) && sound(s.squares);
        });
    if (!whole) throw StateError("a variance of the film is no possible one");
}

std::size_t PixelVariance::memory_bytes() const {
    return first_.capacity() * sizeof(First) + second_.capacity() * sizeof(Second);
}

}  // namespace lxs
