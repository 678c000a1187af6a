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
        all.push_back({.name = "supersample",
                       .type = Bool,
                       .default_text = "false",
                       .doc = "LuxRender's three-tap variant.",
                       .no_effect = true});
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

PixelFilter build(const ParameterReader& reader, double rx, double ry) {
    const std::string& plugin = reader.plugin();
    if (plugin == "mitchell") {
        return {rx, ry,
                radial_cubic(rx, ry, reader.number("B", 1.0 / 3), reader.number("C", 1.0 / 3))};
    }
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

}  // namespace

PixelFilter::PixelFilter(double radius_x, double radius_y,
                         const std::function<double(double, double)>& weight)
    : radius_x_(static_cast<float>(radius_x)),
      radius_y_(static_cast<float>(radius_y)),
      scale_x_(static_cast<float>(kCells / radius_x)),
      scale_y_(static_cast<float>(kCells / radius_y)) {
    for (std::size_t iy = 0; iy < kCells; ++iy) {
        for (std::size_t ix = 0; ix < kCells; ++ix) {
            const double x = (static_cast<double>(ix) + 0.5) / kCells * radius_x;
            const double y = (static_cast<double>(iy) + 0.5) / kCells * radius_y;
            table_[iy * kCells + ix] = static_cast<float>(weight(x, y));
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
