// The running estimate of pixels' luminance.
#include "pixel_importance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "film_pixel.h"

namespace aips {
namespace {

/// Half width of the box that is blurred over, pixels: in the first passes, when photons are few, a
/// wide one.
constexpr int kFirstBlur = 12, kLastBlur = 2;
/// Pixels darker than this share of the mean weigh no more than at it.
constexpr double kDarkest = 0.02;

/// Sums of sliding windows along a line of `count` values, `stride` apart, of ratios' parts.
void sum_windows(const float* from, float* to, int count, std::ptrdiff_t stride, int radius) {
    double sum = 0;
    for (int i = -radius; i < count; ++i) {
        if (i + radius < count) sum += double(from[(i + radius) * stride]);
        if (i - radius - 1 >= 0) sum -= double(from[(i - radius - 1) * stride]);
        if (i >= 0) to[i * stride] = float(std::max(sum, 0.0));
    }
}

/// 1 / L^2 within the floats: their squares' range is wider.
float inverse_square(double squared_luminance) {
    using Limits = std::numeric_limits<float>;
    return float(std::clamp(1 / squared_luminance, double(Limits::min()), double(Limits::max())));
}

/// Of what the eye pass saw by itself.
double mean_luminance(const EyeImage& image) {
    double sum = 0;
    for (const Rgb& radiance : image.radiance)
        sum += double(luminance(radiance));
    return image.positions.empty() ? 0 : sum / double(image.positions.size());
}

}  // namespace

PixelImportance::PixelImportance(std::uint32_t width, std::uint32_t height)
    : width_(width), height_(height) {
    const std::size_t pixels = std::size_t{width} * height;
    for (std::vector<float>* values : {&sum_, &count_, &blurred_, &column_})
        values->assign(pixels, 0.0f);
}

void PixelImportance::add_pass(const EyeImage& image, std::span<const Rgb> radiance) {
    for (std::size_t i = 0; i < image.positions.size(); ++i) {
        const std::size_t at = film_pixel(image.positions[i], width_, height_);
        sum_[at] += luminance_over_groups(radiance, i, image.groups);
        count_[at] += 1;
    }
    ++passes_;
    estimate();
}

void PixelImportance::estimate() {
    double total = 0, paths = 0;
    for (std::size_t i = 0; i < sum_.size(); ++i) {
        total += double(sum_[i]);
        paths += double(count_[i]);
    }
    mean_ = paths > 0 ? total / paths : 0;
    blur();
}

void PixelImportance::blur() {
    const int radius = std::max(kLastBlur, int(kFirstBlur / std::sqrt(double(passes_))));
    const auto box = [&](const std::vector<float>& from, std::vector<float>& to) {
        for (std::uint32_t y = 0; y < height_; ++y)
            sum_windows(&from[std::size_t{y} * width_], &column_[std::size_t{y} * width_],
                        int(width_), 1, radius);
        for (std::uint32_t x = 0; x < width_; ++x)
            sum_windows(&column_[x], &to[x], int(height_), std::ptrdiff_t(width_), radius);
    };
    std::vector<float> counts(count_.size());
    box(count_, counts);
    box(sum_, blurred_);
    for (std::size_t i = 0; i < counts.size(); ++i)
        blurred_[i] = counts[i] > 0 ? blurred_[i] / counts[i] : 0;
}

void PixelImportance::state(StateArchive& archive) {
    constexpr std::uint32_t kMostPasses = 1u << 31;
    archive.value(passes_);
    StateArchive::check(passes_ <= kMostPasses, "passes without end");
    for (std::vector<float>* values : {&sum_, &count_}) {
        archive.fixed(*values);
        StateArchive::check(
            std::all_of(values->begin(), values->end(), [](float v) { return v >= 0; }),
            "a pixel of negative luminance");
    }
    if (archive.restoring() && passes_ > 0) estimate();
}

void PixelImportance::weigh(const EyeImage& image, std::vector<float>& weights) const {
    weights.resize(image.visible_points.size());
    if (!(mean_ > 0)) {
        const double mean = mean_luminance(image);
        std::fill(weights.begin(), weights.end(), mean > 0 ? inverse_square(mean * mean) : 1.0f);
        return;
    }
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const Vec2 position = image.positions[image.visible_points[i].sample];
        weights[i] = weight(film_pixel(position, width_, height_));
    }
}

float PixelImportance::weight(std::size_t pixel) const {
    if (!(mean_ > 0)) return 1;
    const double least = kDarkest * mean_;
    const auto value = double(blurred_[pixel]);
    return inverse_square(value * value + least * least);
}

std::size_t PixelImportance::memory_bytes() const {
    return (sum_.capacity() + count_.capacity() + blurred_.capacity() + column_.capacity()) *
           sizeof(float);
}

std::size_t PixelImportance::memory_bound_bytes(std::size_t pixels) {
    return 5 * pixels * sizeof(float);
}

}  // namespace aips
