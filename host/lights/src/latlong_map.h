// Radiance image over all directions, latitude-longitude mapping.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lxs/sdk/diagnostics.h"
#include "lxs/sdk/types.h"
#include "lxs/spectrum/stored_curve.h"
#include "piecewise_2d.h"

namespace lxs {

class LatLongMap {
  public:
    /// Pixels row by row, top row first.
    LatLongMap(std::size_t width, std::size_t height, std::vector<Rgb> pixels);
    /// Reads an image file. Throws InputError at `where` if the file can't be read; values that are
    /// not finite or negative are taken for 0, with a warning there.
    static LatLongMap read(const std::string& path, const StoredCurve& curve,
                           const SourceLocation& where, Diagnostics& diagnostics);

    /// The image of a function of st, each pixel the mean of 2 x 2 values.
    static LatLongMap of(std::size_t width, std::size_t height,
                         const std::function<Rgb(const Vec2& st)>& value);

    /// The light of L `illuminant` that comes through the map, as LuxRender has it.
    LatLongMap filtering(const Rgb& illuminant) const;
    /// The last row first.
    LatLongMap upside_down() const;
    /// Each row from `row` (above 0) on is as the one before it.
    LatLongMap repeated_from(std::size_t row) const;

    std::size_t width() const { return width_; }
    std::size_t height() const { return height_; }
    /// Value at `st` in [0,1]^2, bilinear; s wraps around, t stops at the poles.
    Rgb lookup(const Vec2& st) const;
    /// Density over the unit square following luminance * sin(pi t), positive wherever lookup is.
    Piecewise2D importance() const;
    /// The same following luminance * `weight`, which is zero where nothing is to be drawn.
    Piecewise2D importance(const std::function<double(const Vec2& st)>& weight) const;
    /// Integral of the pixels times `weight` over the unit square.
    Rgb integral(const std::function<double(const Vec2& st)>& weight) const;
    /// Mean of each row of pixels, top row first.
    std::vector<Rgb> row_means() const;
    /// Integral of the map over all directions.
    Rgb fluence() const;
    /// Integral of the map times the cosine over the hemisphere around +z, the image's top.
    Rgb irradiance() const;

    /// Of a column within one width of the image, which wraps around; rows stop at the poles.
    const Rgb& pixel(std::ptrdiff_t x, std::ptrdiff_t y) const;

  private:
    /// Sum of the pixels times `band` of their polar angles, times the azimuth that they span.
    Rgb over_bands(const std::function<double(double from, double to)>& band) const;
    /// Mean luminance of the bilinear interpolant over one pixel.
    float mean_luminance(std::ptrdiff_t x, std::ptrdiff_t y) const;

    std::size_t width_, height_;
    std::vector<Rgb> pixels_;
};

}  // namespace lxs
