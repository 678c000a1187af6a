// The running estimate of pixels' luminance.
#include "contribution/pixel_importance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/assign_all.h"
#include "base/disjoint_ranges.h"
#include "base/film_pixel.h"
#include "base/ordered_sum.h"
#include "base/parallel_for.h"

namespace aips {
namespace {

/// Passes that the image of another render counts for in the estimate of pixels' luminance.
constexpr std::uint64_t kRememberedPasses = 4;

/// Rows or columns that one job blurs over.
constexpr std::size_t kLinesPerJob = 8;

/// Sums of sliding windows along a line of `count` values, `stride` apart, of ratios' parts. What a
/// bright value leaves behind by rounding, 2^-53 of it, is far below what counts as dark
/// (kDarkestShare).
void sum_windows(const double* from, double* to, int count, std::ptrdiff_t stride, int radius) {
    double sum = 0;
    for (int i = -radius; i < count; ++i) {
        if (i + radius < count) sum += from[(i + radius) * stride];
        if (i - radius - 1 >= 0) sum -= from[(i - radius - 1) * stride];
        if (i >= 0) to[i * stride] = std::max(sum, 0.0);
    }
}

/// A positive float, whatever the units: the range of squared luminances is wider than theirs.
float within_floats(double weight) {
    using Limits = std::numeric_limits<float>;
    return float(std::clamp(weight, double(Limits::min()), double(Limits::max())));
}

}  // namespace

PixelImportance::PixelImportance(std::uint32_t width, std::uint32_t height)
    : width_(width), height_(height) {
    const std::size_t pixels = std::size_t{width} * height;
    for (std::vector<double>* values : {&sum_, &count_, &column_, &window_})
        values->assign(pixels, 0.0);
    blurred_.assign(pixels, 0.0f);
}

void PixelImportance::add_pass(std::span<const PixelLuminance> seen) {
    in_disjoint_ranges(
        seen.size(), [&](std::size_t i) { return seen[i].pixel; },
        [&](std::size_t first, std::size_t last) {
            for (const PixelLuminance& path : seen.subspan(first, last - first)) {
                sum_[path.pixel] += path.luminance;
                count_[path.pixel] += 1;
            }
        });
    ++passes_;
    estimate();
}

void PixelImportance::estimate() {
    const auto sum_of = [](const std::vector<double>& values) {
        return ordered_sum<double>(values.size(), [&](std::size_t first, std::size_t last) {
            const auto begin = values.begin();
            return std::accumulate(begin + std::ptrdiff_t(first), begin + std::ptrdiff_t(last),
                                   0.0);
        });
    };
    const double total = sum_of(sum_), paths = sum_of(count_);
    mean_ = paths > 0 ? total / paths : 0;
    blur();
}

void PixelImportance::blur() {
    const int radius = std::max(kLastBlur, int(kFirstBlur / std::sqrt(double(passes_))));
    const auto box = [&](const std::vector<double>& from) {
        in_chunks(height_, kLinesPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
            for (std::size_t y = first; y < last; ++y)
                sum_windows(&from[y * width_], &column_[y * width_], int(width_), 1, radius);
        });
        in_chunks(width_, kLinesPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
            for (std::size_t x = first; x < last; ++x)
                sum_windows(&column_[x], &window_[x], int(height_), std::ptrdiff_t(width_), radius);
        });
    };
    box(count_);
    for_all(blurred_.size(), [&](std::size_t i) { blurred_[i] = float(window_[i]); });
    box(sum_);
    for_all(blurred_.size(), [&](std::size_t i) {
        blurred_[i] = blurred_[i] > 0 ? float(window_[i] / double(blurred_[i])) : 0;
    });
}

void PixelImportance::state(StateArchive& archive) {
    constexpr std::uint32_t kMostPasses = 1u << 31;
    archive.value(passes_);
    StateArchive::check(passes_ <= kMostPasses, "passes without end");
    for (std::vector<double>* values : {&sum_, &count_}) {
        archive.fixed(*values);
        StateArchive::check(std::all_of(values->begin(), values->end(),
                                        [](double v) { return v >= 0 && std::isfinite(v); }),
                            "a pixel whose luminance is none");
    }
    if (archive.restoring() && passes_ > 0) estimate();
}

void PixelImportance::learned(LearnedParts& parts) {
    const std::uint64_t size = std::uint64_t{width_} << 32 | height_;
    parts.part("brightness of pixels", size, [&](StateArchive& archive) {
        state(archive);
        if (archive.restoring()) fade();
    });
}

void PixelImportance::fade() {
    if (passes_ <= kRememberedPasses) return;
    const double kept = double(kRememberedPasses) / double(passes_);
    for (std::vector<double>* values : {&sum_, &count_}) {
        for (double& value : *values)
            value *= kept;
    }
    passes_ = kRememberedPasses;
    estimate();
}

double PixelImportance::weigh(const EyeImage& image, std::vector<float>& weights) const {
    assign_all(weights, image.visible_points.size(), kUnknownWeight, image.positions.size());
    if (!(mean_ > 0) || weights.empty()) return 1;
    const auto weigh_points = [&](std::size_t first, std::size_t last) {
        double sum = 0;
        for (std::size_t i = first; i < last; ++i) {
            const Vec2 position = image.positions[image.visible_points[i].sample];
            weights[i] = weight(film_pixel(position, width_, height_));
            sum += double(weights[i]);
        }
        return sum;
    };
    const double mean = ordered_sum<double>(weights.size(), weigh_points) / double(weights.size());
    for_all(weights.size(), [&](std::size_t i) {
        const Vec2 position = image.positions[image.visible_points[i].sample];
        const float reached = occlusion_ ? occlusion_->reached_share(position) : 1;
        weights[i] = within_floats(double(weights[i]) / mean * double(reached));
    });
    return mean;
}

float PixelImportance::weight(std::size_t pixel, double darkest_share) const {
    if (!(mean_ > 0)) return 1;
    const double least = darkest_share * mean_;
    const auto value = double(blurred_[pixel]);
    return within_floats(1 / (value * value + least * least));
}

std::size_t PixelImportance::memory_bytes() const {
    return (sum_.capacity() + count_.capacity() + column_.capacity() + window_.capacity()) *
               sizeof(double) +
           blurred_.capacity() * sizeof(float);
}

std::size_t PixelImportance::memory_bound_bytes(std::size_t pixels) {
    return pixels * (4 * sizeof(double) + sizeof(float));
}

}  // namespace aips
