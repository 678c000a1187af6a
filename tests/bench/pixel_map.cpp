// One number for each pixel, and what can be said of where it is large.
#include "pixel_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bench {
namespace {

double sum_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

std::vector<std::size_t> order_of(std::span<const double> values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    return order;
}

std::vector<double> ranks_of(std::span<const double> values) {
    const std::vector<std::size_t> order = order_of(values);
    std::vector<double> ranks(values.size());
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin + 1;
        while (end < order.size() && values[order[end]] == values[order[begin]])
            ++end;
        for (std::size_t i = begin; i < end; ++i)
            ranks[order[i]] = double(begin + end - 1) / 2;
        begin = end;
    }
    return ranks;
}

}  // namespace

std::vector<double> block_means(const PixelMap& map, int side_px) {
    std::vector<double> means;
    for (int top = 0; top + side_px <= map.height_px; top += side_px) {
        for (int left = 0; left + side_px <= map.width_px; left += side_px) {
            double sum = 0;
            for (int y = top; y < top + side_px; ++y) {
                for (int x = left; x < left + side_px; ++x)
                    sum += map.at(x, y);
            }
            means.push_back(sum / (side_px * side_px));
        }
    }
    return means;
}

PixelMap gradient_magnitude(const PixelMap& map) {
    PixelMap gradient{map.width_px, map.height_px, {}};
    gradient.values.reserve(map.values.size());
    for (int y = 0; y < map.height_px; ++y) {
        for (int x = 0; x < map.width_px; ++x) {
            const int left = std::max(x - 1, 0), right = std::min(x + 1, map.width_px - 1);
            const int up = std::max(y - 1, 0), down = std::min(y + 1, map.height_px - 1);
            const double dx = (map.at(right, y) - map.at(left, y)) / std::max(right - left, 1);
            const double dy = (map.at(x, down) - map.at(x, up)) / std::max(down - up, 1);
            gradient.values.push_back(std::hypot(dx, dy));
        }
    }
    return gradient;
}

double quantile(std::vector<double> values, double share) {
    const auto last = double(values.size() - 1);
    const auto middle = values.begin() + std::ptrdiff_t(std::clamp(share, 0.0, 1.0) * last);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

PixelMap shrink(const PixelMap& map, int width_px) {
    if (map.width_px <= width_px) return map;
    PixelMap small{width_px, std::max(1, map.height_px * width_px / map.width_px), {}};
    for (int y = 0; y < small.height_px; ++y) {
        const int top = y * map.height_px / small.height_px;
        const int bottom = (y + 1) * map.height_px / small.height_px;
        for (int x = 0; x < small.width_px; ++x) {
            const int left = x * map.width_px / small.width_px;
            const int right = (x + 1) * map.width_px / small.width_px;
            double sum = 0;
            for (int row = top; row < bottom; ++row) {
                for (int column = left; column < right; ++column)
                    sum += map.at(column, row);
            }
            small.values.push_back(sum / ((bottom - top) * (right - left)));
        }
    }
    return small;
}

std::vector<bool> largest_pixels(const PixelMap& map, double share) {
    const std::vector<std::size_t> order = order_of(map.values);
    const auto count = std::max<std::size_t>(1, std::size_t(share * double(order.size())));
    std::vector<bool> marked(order.size());
    for (std::size_t i = 0; i < std::min(count, order.size()); ++i)
        marked[order[order.size() - 1 - i]] = true;
    return marked;
}

std::optional<double> share_within(const PixelMap& map, const std::vector<bool>& marked) {
    double within = 0;
    for (std::size_t i = 0; i < map.values.size(); ++i)
        within += marked[i] ? map.values[i] : 0;
    const double all = sum_of(map.values);
    if (!(all > 0)) return std::nullopt;
    return within / all;
}

std::optional<double> rank_correlation(std::span<const double> a, std::span<const double> b) {
    if (a.size() < 3) return std::nullopt;
    const std::vector<double> ranks_a = ranks_of(a), ranks_b = ranks_of(b);
    const double mean = double(a.size() - 1) / 2;
    double product = 0, square_a = 0, square_b = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        product += (ranks_a[i] - mean) * (ranks_b[i] - mean);
        square_a += (ranks_a[i] - mean) * (ranks_a[i] - mean);
        square_b += (ranks_b[i] - mean) * (ranks_b[i] - mean);
    }
    if (square_a == 0 || square_b == 0) return std::nullopt;
    return product / std::sqrt(square_a * square_b);
}

std::optional<double> unevenness(std::span<const double> values) {
    const double sum = sum_of(values);
    if (!(sum > 0)) return std::nullopt;
    const double mean = sum / double(values.size());
    double squares = 0;
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    return std::sqrt(squares / double(values.size())) / mean;
}

std::optional<double> distribution_distance(std::span<const double> a, std::span<const double> b) {
    const double sum_a = sum_of(a), sum_b = sum_of(b);
    if (!(sum_a > 0) || !(sum_b > 0)) return std::nullopt;
    double difference = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        difference += std::abs(a[i] / sum_a - b[i] / sum_b);
    return difference / 2;
}

}  // namespace bench
