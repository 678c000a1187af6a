// Radiance image over all directions, latitude-longitude mapping.
#include "latlong_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <numbers>
#include <stdexcept>

#include "emitted_radiance.h"
#include "lxs/images/image_library.h"
#include "lxs/scene/registry.h"
#include "lxs/spectrum/rgb_spectra.h"

namespace lxs {

LatLongMap::LatLongMap(std::size_t width, std::size_t height, std::vector<Rgb> pixels)
    : width_(width), height_(height), pixels_(std::move(pixels)) {
    for (Rgb& c : pixels_)
        c = non_negative(c);
}

LatLongMap LatLongMap::read(const std::string& path, const StoredCurve& curve,
                            const SourceLocation& where, Diagnostics& diagnostics) {
    const ImageLibrary& library = image_library();
    FloatImage file;
    std::vector<Rgb> pixels;
    try {
        file = library.read(path);
        pixels.resize(file.width * file.height);
    } catch (const std::bad_alloc&) {
        throw EndOfReading(where, fmt::format("not enough memory for the image in \"{}\"", path));
    } catch (const std::runtime_error& error) {
        throw InputError(where, fmt::format("cannot read image \"{}\": {}", path, error.what()));
    }
    const bool grey = file.channels < 3;
    std::size_t refused = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const float* v = &file.values[i * file.channels];
        const Rgb stored = grey ? Rgb(v[0]) : Rgb(v[0], v[1], v[2]);
        pixels[i] = non_negative(stored);
        if (!(pixels[i] == stored)) ++refused;
        for (int k = 0; k < 3; ++k)
            pixels[i][k] = curve.linear(pixels[i][k]);
    }
    if (refused > 0) {
        diagnostics.warning(where, fmt::format("image \"{}\" has {} pixels that are not finite or "
                                               "negative; 0 is used",
                                               path, refused));
    }
    return LatLongMap(file.width, file.height, std::move(pixels));
}

const Rgb& LatLongMap::pixel(std::ptrdiff_t x, std::ptrdiff_t y) const {
    const auto w = static_cast<std::ptrdiff_t>(width_), h = static_cast<std::ptrdiff_t>(height_);
    const std::ptrdiff_t column = x < 0 ? x + w : (x >= w ? x - w : x);
    const std::ptrdiff_t row = std::clamp<std::ptrdiff_t>(y, 0, h - 1);
    return pixels_[static_cast<std::size_t>(row * w + column)];
}

Rgb LatLongMap::lookup(const Vec2& st) const {
    const float x = std::clamp(st.x, 0.0f, 1.0f) * static_cast<float>(width_) - 0.5f;
    const float y = std::clamp(st.y, 0.0f, 1.0f) * static_cast<float>(height_) - 0.5f;
    const auto x0 = static_cast<std::ptrdiff_t>(std::floor(x));
    const auto y0 = static_cast<std::ptrdiff_t>(std::floor(y));
    const float dx = x - static_cast<float>(x0), dy = y - static_cast<float>(y0);
    return (pixel(x0, y0) * (1 - dx) + pixel(x0 + 1, y0) * dx) * (1 - dy) +
           (pixel(x0, y0 + 1) * (1 - dx) + pixel(x0 + 1, y0 + 1) * dx) * dy;
}

float LatLongMap::mean_luminance(std::ptrdiff_t x, std::ptrdiff_t y) const {
    constexpr std::array<float, 3> kTent = {0.125f, 0.75f, 0.125f};
    float sum = 0;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i)
            sum += kTent[i] * kTent[j] * luminance(pixel(x + i - 1, y + j - 1));
    }
    return sum;
}

LatLongMap LatLongMap::of(std::size_t width, std::size_t height,
                          const std::function<Rgb(const Vec2& st)>& value) {
    constexpr std::size_t kSub = 2;
    std::vector<Rgb> pixels(width * height, Rgb(0.0f));
    for (std::size_t i = 0; i < pixels.size() * kSub * kSub; ++i) {
        const std::size_t x = i % (width * kSub), y = i / (width * kSub);
        const Vec2 st((static_cast<float>(x) + 0.5f) / static_cast<float>(width * kSub),
                      (static_cast<float>(y) + 0.5f) / static_cast<float>(height * kSub));
        pixels[y / kSub * width + x / kSub] += value(st) / float(kSub * kSub);
    }
    return LatLongMap(width, height, std::move(pixels));
}

LatLongMap LatLongMap::filtering(const Rgb& illuminant) const {
    LatLongMap light = *this;
    for (Rgb& c : light.pixels_)
        c = colour_of_filtered_illuminant(c, illuminant);
    return light;
}

LatLongMap LatLongMap::upside_down() const {
    LatLongMap turned = *this;
    for (std::size_t y = 0; y < height_; ++y)
        std::copy_n(&pixels_[y * width_], width_, &turned.pixels_[(height_ - 1 - y) * width_]);
    return turned;
}

LatLongMap LatLongMap::repeated_from(std::size_t row) const {
    LatLongMap repeated = *this;
    for (std::size_t y = row; y < height_; ++y)
        std::copy_n(&pixels_[(row - 1) * width_], width_, &repeated.pixels_[y * width_]);
    return repeated;
}

Piecewise2D LatLongMap::importance() const {
    return importance([](const Vec2& st) { return std::sin(std::numbers::pi * double(st.y)); });
}

Piecewise2D LatLongMap::importance(const std::function<double(const Vec2& st)>& weight) const {
    // Larger maps share cells: a finer grid costs memory and no longer lowers the variance.
    constexpr std::size_t kMaxWidth = 2048, kMaxHeight = 1024;
    const std::size_t w = std::min(width_, kMaxWidth), h = std::min(height_, kMaxHeight);
    std::vector<double> sums(w * h, 0.0);
    std::vector<std::uint32_t> counts(w * h, 0);
    for (std::size_t y = 0; y < height_; ++y) {
        for (std::size_t x = 0; x < width_; ++x) {
            const std::size_t i = (y * h / height_) * w + x * w / width_;
            sums[i] +=
                mean_luminance(static_cast<std::ptrdiff_t>(x), static_cast<std::ptrdiff_t>(y));
            ++counts[i];
        }
    }
    std::vector<float> weights(w * h);
    for (std::size_t i = 0; i < w * h; ++i) {
        const std::size_t x = i % w, y = i / w;
        const Vec2 center((static_cast<float>(x) + 0.5f) / static_cast<float>(w),
                          (static_cast<float>(y) + 0.5f) / static_cast<float>(h));
        weights[i] = static_cast<float>(sums[i] / counts[i] * weight(center));
    }
    return Piecewise2D(w, h, weights);
}

Rgb LatLongMap::integral(const std::function<double(const Vec2& st)>& weight) const {
    Imath::V3d sum(0.0);
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        const std::size_t x = i % width_, y = i / width_;
        const Vec2 center((static_cast<float>(x) + 0.5f) / static_cast<float>(width_),
                          (static_cast<float>(y) + 0.5f) / static_cast<float>(height_));
        sum += Imath::V3d(pixels_[i]) * weight(center);
    }
    return Rgb(sum / static_cast<double>(pixels_.size()));
}

std::vector<Rgb> LatLongMap::row_means() const {
    std::vector<Rgb> means(height_);
    for (std::size_t y = 0; y < height_; ++y) {
        Imath::V3d sum(0.0);
        for (std::size_t x = 0; x < width_; ++x)
            sum += Imath::V3d(pixels_[y * width_ + x]);
        means[y] = Rgb(sum / static_cast<double>(width_));
    }
    return means;
}

Rgb LatLongMap::over_bands(const std::function<double(double from, double to)>& band) const {
    Imath::V3d sum(0.0);
    const double step = std::numbers::pi / static_cast<double>(height_);
    for (std::size_t y = 0; y < height_; ++y) {
        const double weight =
            band(step * static_cast<double>(y), step * static_cast<double>(y + 1));
        for (std::size_t x = 0; x < width_; ++x)
            sum += Imath::V3d(pixels_[y * width_ + x]) * weight;
    }
    return Rgb(sum * (2 * std::numbers::pi / static_cast<double>(width_)));
}

Rgb LatLongMap::fluence() const {
    return over_bands([](double from, double to) { return std::cos(from) - std::cos(to); });
}

Rgb LatLongMap::irradiance() const {
    const auto below = [](double polar) {
        const double sine = std::sin(std::min(polar, std::numbers::pi / 2));
        return sine * sine / 2;
    };
    return over_bands([&](double from, double to) { return below(to) - below(from); });
}

}  // namespace lxs
