// Images as a page shows them: tone-mapped or as a signed error in colours, in PNG data URIs.
#include "display_image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace bench {
namespace {

constexpr double kPercentile = 0.95;
constexpr double kPercentileValue = 0.8;

using Pixel = std::array<float, 3>;

Pixel pixel_at(const Image& image, int x, int y) {
    Pixel pixel{};
    image.getpixel(x, y, pixel.data(), int(pixel.size()));
    return pixel;
}

/// Rec. 709.
double luminance(const Pixel& pixel) {
    return 0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2];
}

std::uint8_t to_byte(double value) {
    return value > 0 ? std::uint8_t(std::lround(255 * std::min(value, 1.0))) : std::uint8_t{0};
}

template <class Value>
DisplayImage draw(const Crop& crop, const Value& value) {
    DisplayImage drawn{crop.width_px, crop.height_px, {}};
    drawn.pixels.reserve(std::size_t(crop.width_px) * std::size_t(crop.height_px));
    for (int y = 0; y < crop.height_px; ++y) {
        for (int x = 0; x < crop.width_px; ++x)
            drawn.pixels.push_back(value(x, y));
    }
    return drawn;
}

}  // namespace

Rgb8 palette_colour(std::span<const Rgb8> palette, double position) {
    const double at = std::clamp(position, 0.0, 1.0) * double(palette.size() - 1);
    const auto index = std::min(std::size_t(at), palette.size() - 2);
    const double share = at - double(index);
    Rgb8 colour{};
    for (std::size_t i = 0; i < colour.size(); ++i) {
        colour[i] = std::uint8_t(
            std::lround((1 - share) * palette[index][i] + share * palette[index + 1][i]));
    }
    return colour;
}

Rgb8 error_colour(double value) {
    return palette_colour(kErrorColours, std::isnan(value) ? 0.5 : (value + 1) / 2);
}

double automatic_exposure(const Image& image) {
    std::vector<double> values;
    for (int y = 0; y < image.spec().height; ++y) {
        for (int x = 0; x < image.spec().width; ++x) {
            const double value = luminance(pixel_at(image, x, y));
            if (value > 0) values.push_back(value);
        }
    }
    if (values.empty()) return 1;
    const auto nth = values.begin() + std::ptrdiff_t(kPercentile * double(values.size() - 1));
    std::nth_element(values.begin(), nth, values.end());
    return kPercentileValue / *nth;
}

DisplayImage tone_map(const Image& image, const ToneMap& map, const Crop& crop) {
    return draw(crop, [&](int x, int y) {
        const Pixel pixel = pixel_at(image, crop.x + x, crop.y + y);
        Rgb8 shown{};
        for (std::size_t i = 0; i < shown.size(); ++i)
            shown[i] = to_byte(std::pow(std::max(map.exposure * pixel[i], 0.0), 1 / map.gamma));
        return shown;
    });
}

DisplayImage error_map(std::span<const float> differences, double scale, const Crop& crop) {
    return draw(crop, [&](int x, int y) {
        return error_colour(
            differences[std::size_t(y) * std::size_t(crop.width_px) + std::size_t(x)] / scale);
    });
}

std::vector<float> relative_difference(const Image& image, const Image& first, const Image& second,
                                       const Crop& crop) {
    const double floor = std::sqrt(relative_epsilon(first, second));
    std::vector<float> differences;
    for (int y = crop.y; y < crop.y + crop.height_px; ++y) {
        for (int x = crop.x; x < crop.x + crop.width_px; ++x) {
            const double truth =
                (luminance(pixel_at(first, x, y)) + luminance(pixel_at(second, x, y))) / 2;
            differences.push_back(
                float((luminance(pixel_at(image, x, y)) - truth) / (truth + floor)));
        }
    }
    return differences;
}

std::vector<std::string> colour_names(std::span<const Rgb8> palette) {
    std::vector<std::string> names;
    names.reserve(palette.size());
    for (const auto& [red, green, blue] : palette)
        names.push_back(fmt::format("#{:02x}{:02x}{:02x}", red, green, blue));
    return names;
}

std::string png_data_uri(const DisplayImage& image) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput sink(bytes);
    const auto output = OIIO::ImageOutput::create("image.png", &sink);
    if (!output) throw std::runtime_error("OpenImageIO cannot write PNG");
    OIIO::ImageSpec spec(image.width_px, image.height_px, 3, OIIO::TypeDesc::UINT8);
    spec["png:compressionLevel"] = 9;
    const bool written = output->open("image.png", spec) &&
                         output->write_image(OIIO::TypeDesc::UINT8, image.pixels.data()) &&
                         output->close();
    if (!written) throw std::runtime_error("cannot encode a PNG: " + output->geterror());
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return "data:image/png;base64," + OIIO::Strutil::base64_encode({text.data(), text.size()});
}

}  // namespace bench
