// The pixel filter: a table of weights over one quadrant around a pixel's centre.
#include "pixel_filter.h"

#include <algorithm>
#include <vector>

#include "filter_functions.h"
#include "option_choice.h"

namespace lxs {
namespace {

using enum ParameterType;

// A radius beyond this blurs the whole image and makes each pixel read thousands of others.
constexpr double kMinRadius = 0.01, kMaxRadius = 32;

ParameterDeclaration radius_declaration(std::string_view name, std::string_view default_text) {
    return {name,       Float,     default_text, "Radius of the filter along this axis, pixels.",
            kMinRadius, kMaxRadius};
}

std::vector<ParameterDeclaration> declarations(const std::string& plugin,
                                               std::string_view radius_text) {
    std::vector<ParameterDeclaration> all{radius_declaration("xwidth", radius_text),
                                          radius_declaration("ywidth", radius_text)};
    if (plugin == "gaussian") {
        all.push_back({"alpha", Float, "2", "Fall-off: exp(-alpha d^2), per square pixel.", 0});
    } else if (plugin == "mitchell") {
        all.push_back({"B", Float, "0.3333", "Blur of the cubic."});
        all.push_back({"C", Float, "0.3333", "Ringing of the cubic."});
        all.push_back({"supersample", Bool, "false",
                       "A softer sum of three cubics that reaches 5/3 as far, with negative lobes "
                       "of 1 % of the filter in place of 14 %."});
    } else if (plugin == "sinc") {
        all.push_back({"tau", Float, "3", "Number of lobes on either side.", 0.1, 100});
    }
    return all;
}

struct DefaultRadius {
    double value;
    std::string_view text;
};

DefaultRadius default_radius(const std::string& plugin) {
    if (plugin == "box") return {0.5, "0.5"};
    if (plugin == "sinc" || plugin == "blackmanharris") return {4, "4"};
    return {2, "2"};
}

/// The Mitchell-Netravali cubic of the distance, scaled so that the radii are its support:
/// LuxRender evaluates its cubics radially, not as a product.
auto radial_cubic(double rx, double ry, double b, double c) {
    return [=](double x, double y) { return mitchell_1d(2 * std::hypot(x / rx, y / ry), b, c); };
}

PixelFilter mitchell(const ParameterReader& reader, double rx, double ry) {
    const double b = reader.number("B", 1.0 / 3), c = reader.number("C", 1.0 / 3);
    if (!reader.boolean("supersample", false)) return {rx, ry, radial_cubic(rx, ry, b, c)};
    return {kSupersampledReach * rx, kSupersampledReach * ry, [=](double x, double y) {
                return supersampled_mitchell_1d(2 * std::hypot(x / rx, y / ry), b, c);
            }};
}

PixelFilter build(const ParameterReader& reader, double rx, double ry) {
    const std::string& plugin = reader.plugin();
    if (plugin == "mitchell") return mitchell(reader, rx, ry);
    if (plugin == "catmullrom") return {rx, ry, radial_cubic(rx, ry, 0, 0.5)};
    if (plugin == "gaussian") {
        const double alpha = reader.number("alpha", 2);
        return {rx, ry, [=](double x, double y) {
                    return gaussian_1d(x, rx, alpha) * gaussian_1d(y, ry, alpha);
                }};
    }
    if (plugin == "triangle") {
        return {rx, ry,
                [=](double x, double y) { return triangle_1d(x, rx) * triangle_1d(y, ry); }};
    }
    if (plugin == "blackmanharris") {
        return {rx, ry, [=](double x, double y) {
                    return blackman_harris_1d(x, rx) * blackman_harris_1d(y, ry);
                }};
    }
    if (plugin == "sinc") {
        const double tau = reader.number("tau", 3);
        return {rx, ry, [=](double x, double y) {
                    return lanczos_sinc_1d(x, rx, tau) * lanczos_sinc_1d(y, ry, tau);
                }};
    }
    return {rx, ry, [](double, double) { return 1.0; }};
}

/// A whole number, so that one position lies alike in the tables of all pixels; some 64 cells in a
/// radius.
float cells_per_pixel(double radius) {
    constexpr double kCells = 64, kFewest = 4;
    return static_cast<float>(std::max(kFewest, std::floor(kCells / radius)));
}

/// Cells of a table of `count` along one axis in which the pixels of a row see a sample that one of
/// them sees in `cell`.
std::vector<std::size_t> cells_of_all_pixels(std::size_t cell, std::size_t per_pixel,
                                             std::size_t count) {
    const std::size_t within = cell % per_pixel;
    std::vector<std::size_t> cells;
    for (std::size_t begin = 0; begin < count; begin += per_pixel) {
        for (const std::size_t seen : {begin + within, begin + per_pixel - 1 - within}) {
            if (seen < count) cells.push_back(seen);
        }
    }
    return cells;
}

}  // namespace

PixelFilter::PixelFilter(double radius_x, double radius_y,
                         const std::function<double(double, double)>& weight)
    : radius_x_(static_cast<float>(radius_x)),
      radius_y_(static_cast<float>(radius_y)),
      scale_x_(cells_per_pixel(radius_x)),
      scale_y_(cells_per_pixel(radius_y)),
      columns_(static_cast<std::size_t>(std::ceil(radius_x * scale_x_))),
      rows_(static_cast<std::size_t>(std::ceil(radius_y * scale_y_))),
      table_(columns_ * rows_) {
    // In the middle of what of a cell is within the radius.
    const auto middle = [](std::size_t cell, double scale, double radius) {
        const auto first = static_cast<double>(cell);
        return (first / scale + std::min((first + 1) / scale, radius)) / 2;
    };
    for (std::size_t iy = 0; iy < rows_; ++iy) {
        for (std::size_t ix = 0; ix < columns_; ++ix) {
            table_[iy * columns_ + ix] = static_cast<float>(
                weight(middle(ix, scale_x_, radius_x), middle(iy, scale_y_, radius_y)));
        }
    }
    sum_to_one();
    negative_ = std::any_of(table_.begin(), table_.end(), [](float w) { return w < 0; });
}

PixelFilter PixelFilter::central_lobe() const {
    if (!negative_) return *this;
    // Cells that are reached from the centre without crossing zero; within a quadrant a lobe is
    // monotone along both axes.
    std::vector<bool> inside(table_.size());
    PixelFilter lobe;
    for (std::size_t iy = 0; iy < rows_; ++iy) {
        for (std::size_t ix = 0; ix < columns_; ++ix) {
            const std::size_t i = iy * columns_ + ix;
            const bool first = ix == 0 && iy == 0;
            const bool next = (ix > 0 && inside[i - 1]) || (iy > 0 && inside[i - columns_]);
            inside[i] = table_[i] > 0 && (first || next);
            if (!inside[i]) continue;
            lobe.columns_ = std::max(lobe.columns_, ix + 1);
            lobe.rows_ = std::max(lobe.rows_, iy + 1);
        }
    }
    if (lobe.columns_ == 0) return {0.5, 0.5, [](double, double) { return 1.0; }};
    lobe.scale_x_ = scale_x_;
    lobe.scale_y_ = scale_y_;
    lobe.radius_x_ = std::min(radius_x_, static_cast<float>(lobe.columns_) / scale_x_);
    lobe.radius_y_ = std::min(radius_y_, static_cast<float>(lobe.rows_) / scale_y_);
    for (std::size_t iy = 0; iy < lobe.rows_; ++iy) {
        for (std::size_t ix = 0; ix < lobe.columns_; ++ix) {
            const std::size_t i = iy * columns_ + ix;
            lobe.table_.push_back(inside[i] ? table_[i] : 0);
        }
    }
    lobe.sum_to_one();
    return lobe;
}

/// Divides by what a sample weighs in all pixels together. Where that is little, as between the
/// pixels of a cubic narrower than they are, a part of the filter's peak is taken for it, lest
/// single samples outshine all others.
void PixelFilter::sum_to_one() {
    const double least = 0.1 * double{*std::max_element(table_.begin(), table_.end())};
    if (!(least > 0)) return;
    const std::size_t per_x = columns_per_pixel(), per_y = rows_per_pixel();
    std::vector<double> along_x(table_.size());
    for (std::size_t ix = 0; ix < columns_; ++ix) {
        for (const std::size_t other : cells_of_all_pixels(ix, per_x, columns_)) {
            for (std::size_t iy = 0; iy < rows_; ++iy)
                along_x[iy * columns_ + ix] += table_[iy * columns_ + other];
        }
    }
    for (std::size_t iy = 0; iy < rows_; ++iy) {
        const std::vector<std::size_t> rows = cells_of_all_pixels(iy, per_y, rows_);
        for (std::size_t ix = 0; ix < columns_; ++ix) {
            double sum = 0;
            for (const std::size_t other : rows)
                sum += along_x[other * columns_ + ix];
            table_[iy * columns_ + ix] =
                static_cast<float>(table_[iy * columns_ + ix] / std::max(sum, least));
        }
    }
}

std::vector<ParameterDeclaration> filter_parameters(const std::string& plugin) {
    return declarations(plugin, default_radius(plugin).text);
}

PixelFilter make_pixel_filter(const SceneContents& contents, Diagnostics& diagnostics) {
    const OptionChoice choice = choose_option(
        contents, "PixelFilter", "mitchell",
        {"blackmanharris", "box", "catmullrom", "gaussian", "mitchell", "sinc", "triangle"});
    const ParameterSet& set = choice.statement.parameters;
    const DefaultRadius radius = default_radius(set.plugin);
    const std::vector<ParameterDeclaration> declared = declarations(set.plugin, radius.text);
    const ParameterReader reader(set, declared, diagnostics);
    return build(reader, reader.number("xwidth", radius.value),
                 reader.number("ywidth", radius.value));
}

}  // namespace lxs
