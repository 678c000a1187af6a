// The pixel filter: a table of weights over one quadrant around a pixel's centre.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "lxs/scene/contents.h"
#include "lxs/sdk/parameters.h"

namespace lxs {

/// Weights of a filter that is even in x and y, tabulated once. As in LuxRender, those that one
/// sample has for all pixels around it sum to 1, wherever in a pixel it lies, so that what a film
/// without end receives is what its samples bring. (The filters themselves keep that but roughly:
/// a sample counts 0.67 to 1.39 under a radial cubic of radius 1.5.)
class PixelFilter {
  public:
    /// `weight(x, y)` is the filter at an offset in pixels, at any scale; the radii are in pixels,
    /// > 0.
    PixelFilter(double radius_x, double radius_y,
                const std::function<double(double, double)>& weight);

    float radius_x() const { return radius_x_; }
    float radius_y() const { return radius_y_; }

    /// Weight of a sample at the offset (dx, dy) from the pixel's centre; 0 outside of the radii.
    float weight(float dx, float dy) const {
        const float ax = std::abs(dx), ay = std::abs(dy);
        if (!(ax <= radius_x_ && ay <= radius_y_)) return 0;
        const auto ix = std::min(static_cast<std::size_t>(ax * scale_x_), columns_ - 1);
        const auto iy = std::min(static_cast<std::size_t>(ay * scale_y_), rows_ - 1);
        return table_[iy * columns_ + ix];
    }

    /// Of the table: cells are counted from the centre outwards, the last ones may reach beyond the
    /// radii.
    std::size_t columns() const { return columns_; }
    std::size_t rows() const { return rows_; }
    /// Whole numbers: cells of neighbouring pixels' tables cover one another.
    std::size_t columns_per_pixel() const { return static_cast<std::size_t>(scale_x_); }
    std::size_t rows_per_pixel() const { return static_cast<std::size_t>(scale_y_); }
    /// Weight anywhere in a cell of the table.
    float cell(std::size_t column, std::size_t row) const {
        return table_[row * columns_ + column];
    }

    bool has_negative_weights() const { return negative_; }
    /// The part of it around its centre that is above zero, with radii no larger than it needs; the
    /// weights that one sample has for all pixels sum to 1 again.
    PixelFilter central_lobe() const;

  private:
    PixelFilter() = default;
    void sum_to_one();

    float radius_x_ = 0, radius_y_ = 0;
    float scale_x_ = 1, scale_y_ = 1;  ///< cells per pixel
    std::size_t columns_ = 0, rows_ = 0;
    std::vector<float> table_;  ///< some 16 KB, which the L1 cache holds
    bool negative_ = false;
};

/// Filter of the scene's PixelFilter statement (default: mitchell, radius 2).
PixelFilter make_pixel_filter(const SceneContents& contents, Diagnostics& diagnostics);

/// Declared parameters of the filter `plugin`.
std::vector<ParameterDeclaration> filter_parameters(const std::string& plugin);

}  // namespace lxs
