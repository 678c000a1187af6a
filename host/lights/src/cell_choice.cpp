// Choice among the cells of a grid, with probabilities that are exactly those drawn.
#include "cell_choice.h"

#include <algorithm>

#include "lxs/sdk/quantized_cdf.h"
#include "warp.h"

namespace lxs {
namespace {

/// Where in its step `u` falls, a multiple of 2^-24: in the middle of all that have the same bits,
/// as a step may hold few of them.
float share_of_step(float u, float low, float high) {
    return clamp_to_unit(
        static_cast<float>((double(u) + 0x1p-25 - double(low)) / (double(high) - double(low))));
}

}  // namespace

CellChoice::CellChoice(std::size_t width, std::size_t height, std::span<const float> weights)
    : width_(width), height_(height), rows_(height + 1), columns_((width + 1) * height) {
    std::vector<double> sums(height);
    std::size_t first = 0;
    for (std::size_t row = 0; row < height; ++row) {
        const std::size_t cells = std::min(width, weights.size() - first);
        const auto cdf = std::span(columns_).subspan(row * (width + 1), width + 1);
        sums[row] = quantize_cdf(weights.subspan(first, cells), cdf.first(cells + 1));
        std::fill(cdf.begin() + static_cast<std::ptrdiff_t>(cells), cdf.end(), cdf[cells]);
        first += cells;
    }
    total_ = quantize_cdf(std::span<const double>(sums), std::span(rows_));
}

DrawnCell CellChoice::draw(const Vec2& u) const {
    DrawnCell drawn;
    drawn.row = find_step(rows_, double(u.y));
    const std::span<const float> cells(&columns_[drawn.row * (width_ + 1)], width_ + 1);
    drawn.column = find_step(cells, double(u.x));
    drawn.share.x = share_of_step(u.x, cells[drawn.column], cells[drawn.column + 1]);
    drawn.share.y = share_of_step(u.y, rows_[drawn.row], rows_[drawn.row + 1]);
    drawn.probability = probability(drawn.row, drawn.column);
    return drawn;
}

bool CellChoice::coordinates(std::size_t row, std::size_t column, const Vec2& share,
                             Vec2& u) const {
    if (!(probability(row, column) > 0)) return false;
    const float* cell = &columns_[row * (width_ + 1) + column];
    u = Vec2(within_interval(cell[0], cell[1], share.x),
             within_interval(rows_[row], rows_[row + 1], share.y));
    return true;
}

}  // namespace lxs
