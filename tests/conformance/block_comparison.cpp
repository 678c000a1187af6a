// How far an image is from its reference: relative differences of block means.
#include "block_comparison.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "block_test.h"

namespace conformance {
namespace {

using Blocks = std::vector<double>;

void check_sizes(const render::Image& a, const render::Image& b) {
    if (a.width != b.width || a.height != b.height)
        throw std::invalid_argument("images of different sizes");
    if (a.width < kBlock || a.height < kBlock)
        throw std::invalid_argument("images smaller than a block");
}

Blocks channel_blocks(const render::Image& image, std::size_t channel) {
    std::vector<double> values(image.width * image.height);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = double(image.rgb[3 * i + channel]);
    return statistics::block_means(values, image.width, image.height, kBlock);
}

double mean_of(const Blocks& blocks) {
    return std::accumulate(blocks.begin(), blocks.end(), 0.0) / double(blocks.size());
}

/// Value below which `share` of the sorted values lie, linear between ranks.
double percentile(const std::vector<double>& sorted, double share) {
    const double rank = share * double(sorted.size() - 1);
    const auto below = std::size_t(rank);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], rank - double(below));
}

Spread spread(std::vector<double> values) {
    // What is no number is the worst: it must not hide in an order that it breaks.
    for (double& v : values)
        if (std::isnan(v)) v = INFINITY;
    std::sort(values.begin(), values.end());
    return {percentile(values, 0.5), percentile(values, 0.95)};
}

Spread relative_differences(const Blocks& a, const Blocks& b) {
    constexpr double kBlack = 1e-6;  // of the mean
    const double least = std::max(kBlack * std::abs(mean_of(b)), 1e-30);
    std::vector<double> values(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        values[i] = std::abs(a[i] - b[i]) / std::max(b[i], least);
    return spread(std::move(values));
}

}  // namespace

Comparison compare(const render::Image& a, const render::Image& b) {
    check_sizes(a, b);
    Comparison found;
    found.luminance = relative_differences(a.block_means(kBlock), b.block_means(kBlock));
    for (std::size_t c = 0; c < 3; ++c) {
        const Blocks ours = channel_blocks(a, c), theirs = channel_blocks(b, c);
        found.channels[c] = relative_differences(ours, theirs);
        found.mean_ratio[c] = mean_of(ours) / mean_of(theirs);
    }
    return found;
}

Spread noise_of_mean(const render::Image& a, const render::Image& b) {
    check_sizes(a, b);
    const Blocks middle = mean(a, b).block_means(kBlock);
    // (a - b) / 2 is as large as the error of the mean, and lies between a and the mean.
    return relative_differences(a.block_means(kBlock), middle);
}

render::Image mean(const render::Image& a, const render::Image& b) {
    check_sizes(a, b);
    render::Image result = a;
    for (std::size_t i = 0; i < result.rgb.size(); ++i)
        result.rgb[i] = 0.5f * (a.rgb[i] + b.rgb[i]);
    return result;
}

std::size_t negatives(const render::Image& image) {
    return std::size_t(
        std::count_if(image.rgb.begin(), image.rgb.end(), [](float v) { return v < 0; }));
}

std::size_t not_finite(const render::Image& image) {
    return std::size_t(std::count_if(image.rgb.begin(), image.rgb.end(),
                                     [](float v) { return !std::isfinite(v); }));
}

}  // namespace conformance
