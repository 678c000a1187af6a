// Sampling of piecewise constant densities over the unit square.
#include "aips/core/tables/directional_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "aips/core/sampling/sampling.h"
#include "tables/quantized_cdf.h"

namespace aips {
namespace {

/// Cell of [0, 1) that holds x.
int interval_of(float x, int resolution) {
    return std::min(static_cast<int>(clamp_to_unit(x) * float(resolution)), resolution - 1);
}

/// The point at `within` [0, 1) of a cell. Rounding must not move it to a neighbour, where pdf()
/// would look up another density.
float place(int cell, float within, int resolution) {
    float x = clamp_to_unit((float(cell) + within) / float(resolution));
    while (interval_of(x, resolution) < cell)
        x = std::nextafter(x, 2.0f);
    while (interval_of(x, resolution) > cell)
        x = std::nextafter(x, -1.0f);
    return x;
}

/// An alternative of a cumulative distribution, its probability, and where u falls within it.
struct Step {
    int index;
    float probability;
    float within;
};

Step find_step(std::span<const float> cdf, float u) {
    int i = 0;
    while (cdf[std::size_t(i)] <= u)
        ++i;
    const float lower = i == 0 ? 0.0f : cdf[std::size_t(i - 1)];
    const float upper = cdf[std::size_t(i)];
    return {i, upper - lower, stretch(u, lower, upper)};
}

}  // namespace

float sanitized_weight(float weight) {
    return weight > 0 ? std::min(weight, std::numeric_limits<float>::max()) : 0.0f;
}

std::size_t cell_index(Vec2 point, int resolution) {
    return std::size_t(interval_of(point.y, resolution)) * std::size_t(resolution) +
           std::size_t(interval_of(point.x, resolution));
}

DirectionalTable::DirectionalTable(int resolution) : resolution_(resolution) {
    if (resolution < 1 || resolution > 2048) {
        throw std::invalid_argument("DirectionalTable: resolution must be in [1, 2048]");
    }
    const auto n = static_cast<std::size_t>(resolution);
    row_cdf_.resize(n);
    cell_cdf_.resize(n * n);
    build(std::vector<float>(n * n, 1.0f));
}

void DirectionalTable::build(std::span<const float> weights) {
    if (weights.size() != cell_cdf_.size()) {
        throw std::invalid_argument("DirectionalTable: needs resolution^2 weights");
    }
    const auto n = static_cast<std::size_t>(resolution_);
    std::vector<float> clean(weights.size());
    std::transform(weights.begin(), weights.end(), clean.begin(), sanitized_weight);
    if (std::all_of(clean.begin(), clean.end(), [](float w) { return w == 0; })) {
        std::fill(clean.begin(), clean.end(), 1.0f);
    }
    std::vector<double> rows(n);
    double total = 0;
    for (std::size_t y = 0; y < n; ++y) {
        const std::span<const float> row(clean.data() + y * n, n);
        for (const float w : row)
            rows[y] += double(w);
        total += rows[y];
        const std::span<float> cdf(cell_cdf_.data() + y * n, n);
        std::fill(cdf.begin(), cdf.end(), 0.0f);
        if (rows[y] > 0) quantize_cdf(row, rows[y], cdf);
    }
    quantize_cdf(std::span<const double>(rows), total, row_cdf_);
}

std::size_t DirectionalTable::memory_bytes(int resolution) {
    const auto n = static_cast<std::size_t>(resolution);
    return sizeof(DirectionalTable) + (n + n * n) * sizeof(float);
}

SquareSample DirectionalTable::sample(Vec2 u) const {
    const auto n = static_cast<std::size_t>(resolution_);
    const Step row = find_step(row_cdf_, clamp_to_unit(u.y));
    const std::span<const float> cells(cell_cdf_.data() + std::size_t(row.index) * n, n);
    const Step cell = find_step(cells, clamp_to_unit(u.x));
    const float area = 1.0f / float(resolution_ * resolution_);
    return {
        {place(cell.index, cell.within, resolution_), place(row.index, row.within, resolution_)},
        row.probability * cell.probability / area};
}

float DirectionalTable::pdf(Vec2 point) const {
    const std::size_t cell = cell_index(point, resolution_);
    const auto n = static_cast<std::size_t>(resolution_);
    const std::size_t y = cell / n;
    const float row = row_cdf_[y] - (y == 0 ? 0.0f : row_cdf_[y - 1]);
    const float in_row = cell_cdf_[cell] - (cell % n == 0 ? 0.0f : cell_cdf_[cell - 1]);
    const float area = 1.0f / float(resolution_ * resolution_);
    return row * in_row / area;
}

CellWeights::CellWeights(std::span<const float> weights, int resolution)
    : weights_(weights), resolution_(resolution) {
    double sum = 0;
    for (const float w : weights_)
        sum += double(w);
    threshold_ =
        std::max(sum * (0x1p-24 / double(weights_.size())), std::numeric_limits<double>::min());
    for (std::size_t i = 0; i < weights_.size(); ++i)
        total_ += kept(i);
}

SquareSample CellWeights::sample(Vec2 u) const {
    const auto n = static_cast<std::size_t>(resolution_);
    // Rows, then cells, by walking along the running sum; `found` stays at the last positive one
    // should rounding let the walk run over the end.
    const auto walk = [](std::size_t count, double target, auto&& weight_of) {
        std::size_t found = 0;
        double lower = 0, width = 0, sum = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double w = weight_of(i);
            if (w <= 0) continue;
            found = i;
            lower = sum;
            width = w;
            sum += w;
            if (target < sum) break;
        }
        return Walk{found, width, clamp_to_unit(float((target - lower) / width))};
    };
    const Walk row =
        walk(n, double(clamp_to_unit(u.y)) * total_, [&](std::size_t y) { return row_sum(y); });
    const Walk cell = walk(n, double(clamp_to_unit(u.x)) * row.width,
                           [&](std::size_t x) { return kept(row.index * n + x); });
    return {{place(int(cell.index), cell.within, resolution_),
             place(int(row.index), row.within, resolution_)},
            float(cell.width / total_ * double(weights_.size()))};
}

float CellWeights::pdf(Vec2 point) const {
    if (empty()) return 0;
    return float(kept(cell_index(point, resolution_)) / total_ * double(weights_.size()));
}

double CellWeights::row_sum(std::size_t y) const {
    const auto n = static_cast<std::size_t>(resolution_);
    double sum = 0;
    for (std::size_t x = 0; x < n; ++x)
        sum += kept(y * n + x);
    return sum;
}

}  // namespace aips
