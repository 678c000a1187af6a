// The pixel filter: a table of weights over one quadrant around a pixel's centre.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>

#include "lxs/scene/contents.h"
#include "lxs/sdk/parameters.h"

namespace lxs {

/// Weights of a filter that is even in x and y, tabulated once: the sum over samples is divided by
/// the sum of weights, so that neither the filter's scale nor the table's steps show.
class PixelFilter {
  public:
    /// `weight(x, y)` is the filter at an offset in pixels; the radii are in pixels, > 0.
    PixelFilter(double radius_x, double radius_y,
                const std::function<double(double, double)>& weight);

    float radius_x() const { return radius_x_; }
    float radius_y() const { return radius_y_; }

    /// Weight of a sample at the offset (dx, dy) from the pixel's centre; 0 outside of the radii.
    float weight(float dx, float dy) const {
        const float ax = std::abs(dx), ay = std::abs(dy);
        if (!(ax <= radius_x_ && ay <= radius_y_)) return 0;
        const auto ix = std::min(static_cast<std::size_t>(ax * scale_x_), kCells - 1);
        const auto iy = std::min(static_cast<std::size_t>(ay * scale_y_), kCells - 1);
        return table_[iy * kCells + ix];
    }

    static constexpr std::size_t kCells = 64;  ///< per axis: 16 KB, which the L1 cache holds
    /// Weight anywhere in a cell of the table: column and row count from the centre outwards.
    float cell(std::size_t column, std::size_t row) const { return table_[row * kCells + column]; }

  private:
    float radius_x_, radius_y_;
    float scale_x_, scale_y_;
    std::array<float, kCells * kCells> table_;
};

/// Filter of the scene's PixelFilter statement (default: mitchell, radius 2).
PixelFilter make_pixel_filter(const SceneContents& contents, Diagnostics& diagnostics);

/// Declared parameters of the filter `plugin`.
std::vector<ParameterDeclaration> filter_parameters(const std::string& plugin);

}  // namespace lxs
