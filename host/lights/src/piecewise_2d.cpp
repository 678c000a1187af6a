// Piecewise-constant density over the unit square.
#include "piecewise_2d.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "warp.h"

namespace lxs {
namespace {

/// Writes the normalised CDF of `weights` and returns their sum; the last value is exactly 1.
double accumulate(std::span<const float> weights, std::span<float> cdf) {
    double total = 0;
    for (const float w : weights)
        total += w;
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        cdf[i] = total > 0 ? static_cast<float>(sum / total) : 0.0f;
        sum += weights[i];
    }
    cdf[weights.size()] = 1.0f;
    return total;
}

/// Inverts a CDF: the position in [0, n) whose integer part is the cell.
float invert(std::span<const float> cdf, float u) {
    const auto above = std::upper_bound(cdf.begin() + 1, cdf.end() - 1, u);
    const auto i = above - cdf.begin() - 1;
    const float width = cdf[i + 1] - cdf[i];
    const float share = width > 0 ? (u - cdf[i]) / width : 0.5f;
    constexpr float kBelowOne = 0x1.fffffep-1f;
    return static_cast<float>(i) + std::clamp(share, 0.0f, kBelowOne);
}

/// Inverse of invert for a position whose integer part is cell `i`; false if it is never drawn.
bool revert(std::span<const float> cdf, float position, std::size_t i, float& u) {
    if (!(cdf[i + 1] > cdf[i])) return false;
    const float share = std::clamp(position - static_cast<float>(i), 0.0f, 1.0f);
    u = within_interval(cdf[i], cdf[i + 1], share);
    return true;
}

std::size_t cell(float x, std::size_t n) {
    if (!(x > 0)) return 0;
    return std::min(static_cast<std::size_t>(x * static_cast<float>(n)), n - 1);
}

}  // namespace

Piecewise2D::Piecewise2D(std::size_t width, std::size_t height, const std::vector<float>& weights)
    : width_(width),
      height_(height),
      densities_(weights),
      rows_(height + 1),
      columns_((width + 1) * height) {
    std::vector<float> row_sums(height);
    for (std::size_t y = 0; y < height; ++y) {
        const std::span<const float> row(&weights[y * width], width);
        row_sums[y] =
            static_cast<float>(accumulate(row, std::span(&columns_[y * (width + 1)], width + 1)));
    }
    total_ = accumulate(row_sums, rows_);
    if (!(total_ > 0)) return;
    const double mean = total_ / (static_cast<double>(width) * static_cast<double>(height));
    for (float& d : densities_)
        d = static_cast<float>(d / mean);
}

Vec2 Piecewise2D::sample(const Vec2& u, float& density) const {
    const float y = invert(rows_, u.y);
    const auto row = std::min(static_cast<std::size_t>(y), height_ - 1);
    const float x = invert(std::span(&columns_[row * (width_ + 1)], width_ + 1), u.x);
    const auto column = std::min(static_cast<std::size_t>(x), width_ - 1);
    density = densities_[row * width_ + column];
    return Vec2(x / static_cast<float>(width_), y / static_cast<float>(height_));
}

float Piecewise2D::density(const Vec2& p) const {
    if (!positive()) return 0;
    return densities_[cell(p.y, height_) * width_ + cell(p.x, width_)];
}

bool Piecewise2D::coordinates(const Vec2& p, Vec2& u) const {
    if (!positive()) return false;
    const std::size_t row = cell(p.y, height_), column = cell(p.x, width_);
    const std::span<const float> in_row(&columns_[row * (width_ + 1)], width_ + 1);
    return revert(rows_, p.y * static_cast<float>(height_), row, u.y) &&
           revert(in_row, p.x * static_cast<float>(width_), column, u.x);
}

}  // namespace lxs
