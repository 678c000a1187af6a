// One number for each pixel, and what can be said of where it is large.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace bench {

/// Row by row.
struct PixelMap {
    int width_px = 0, height_px = 0;
    std::vector<double> values;

    double at(int x, int y) const { return values[std::size_t(y) * width_px + x]; }
};

/// Means over blocks of `side_px` x `side_px` pixels; pixels beyond the last whole block are left
/// out.
std::vector<double> block_means(const PixelMap& map, int side_px);

/// Magnitude of the gradient by central differences, one-sided at the border.
PixelMap gradient_magnitude(const PixelMap& map);

/// The value that `share` (0 to 1) of the values don't exceed; there must be some.
double quantile(std::vector<double> values, double share);

/// Box means in at most `width_px` columns, in proportion; the map itself if it is no wider.
PixelMap shrink(const PixelMap& map, int width_px);

/// Marks the `share` (0 to 1) of the pixels where the map is largest, at least one.
std::vector<bool> largest_pixels(const PixelMap& map, double share);

/// Part of the map's sum in the marked pixels; nothing if the sum is not positive.
std::optional<double> share_within(const PixelMap& map, const std::vector<bool>& marked);

/// Spearman's: 1 if one rises wherever the other does, ties at their mean rank. Nothing with fewer
/// than three values, or if either has one value throughout.
std::optional<double> rank_correlation(std::span<const double> a, std::span<const double> b);

/// Standard deviation divided by mean; nothing if the mean is not positive.
std::optional<double> unevenness(std::span<const double> values);

/// Half the sum of |a - b|, each divided by its own sum: 0 if they are alike, 1 if nowhere both.
/// Nothing if either sum is not positive.
std::optional<double> distribution_distance(std::span<const double> a, std::span<const double> b);

}  // namespace bench
