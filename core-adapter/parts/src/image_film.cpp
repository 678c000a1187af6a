// Sums and weights of every pixel.
#include "aips/parts/image_film.h"

#include <algorithm>
#include <stdexcept>

namespace aips {
namespace {

/// Values must be as many as they ought to be, or pixels would get each other's.
void require(std::size_t values, std::size_t expected, const char* what) {
    if (values == expected) return;
    throw std::invalid_argument(std::string("ImageFilm: ") + std::to_string(values) + ' ' + what +
                                ", expected " + std::to_string(expected));
}

double mean_luminance(const std::vector<Rgb>& pixels) {
    double sum = 0;
    for (const Rgb& pixel : pixels)
        sum += luminance(pixel);
    return sum / double(pixels.size());
}

}  // namespace

PixelMean::PixelMean(std::uint32_t width, std::uint32_t height, std::uint32_t groups)
    : width_(width),
      height_(height),
      groups_(groups),
      sums_(std::size_t(width) * height * groups * 3),
      weights_(std::size_t(width) * height) {}

std::size_t PixelMean::pixel_of(Vec2 position) const {
    const auto x = std::min(width_ - 1, static_cast<std::uint32_t>(position.x));
    const auto y = std::min(height_ - 1, static_cast<std::uint32_t>(position.y));
    return std::size_t(y) * width_ + x;
}

void PixelMean::add(std::span<const Vec2> positions, std::span<const Rgb> radiance, double weight) {
    require(radiance.size(), positions.size() * groups_, "values of samples in a pass");
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const std::size_t pixel = pixel_of(positions[i]);
        weights_[pixel] += weight;
        for (std::uint32_t g = 0; g < groups_; ++g) {
            const Rgb& value = radiance[i * groups_ + g];
            double* sum = &sums_[(pixel * groups_ + g) * 3];
            sum[0] += weight * value.r;
            sum[1] += weight * value.g;
            sum[2] += weight * value.b;
        }
    }
}

void PixelMean::add_to(std::vector<Rgb>& pixels, std::uint32_t first, std::uint32_t last) const {
    for (std::size_t p = 0; p < pixels.size(); ++p) {
        const double weight = weights_[p];
        if (!(weight > 0)) continue;
        for (std::uint32_t g = first; g < last; ++g) {
            const double* sum = &sums_[(p * groups_ + g) * 3];
            pixels[p] += {float(sum[0] / weight), float(sum[1] / weight), float(sum[2] / weight)};
        }
    }
}

std::vector<Rgb> PixelMean::image() const {
    std::vector<Rgb> pixels(weights_.size());
    add_to(pixels, 0, groups_);
    return pixels;
}

double PixelMean::mean() const {
    return mean_luminance(image());
}

ImageFilm::ImageFilm(std::uint32_t width, std::uint32_t height, std::uint32_t groups)
    : width_(width),
      height_(height),
      groups_(groups),
      eye_(width, height, groups),
      photons_(width, height, groups) {}

void ImageFilm::add_pass(const FilmPass& pass) {
    require(pass.groups, groups_, "light groups in a pass");
    eye_.add(pass.positions, pass.eye, 1);
    if (!pass.photons.empty()) photons_.add(pass.positions, pass.photons, pass.photon_weight);
    if (pass.splats) add_splats(*pass.splats);
}

void ImageFilm::add_splats(const FilmSplats& splats) {
    require(splats.radiance.size(), splats.positions.size() * groups_, "values of splats");
    splats_.resize(std::size_t(width_) * height_ * groups_ * 3);
    ++splat_passes_;
    for (std::size_t i = 0; i < splats.radiance.size(); ++i) {
        const std::size_t pixel = eye_.pixel_of(splats.positions[i / groups_]);
        double* sum = &splats_[(pixel * groups_ + i % groups_) * 3];
        sum[0] += splats.radiance[i].r;
        sum[1] += splats.radiance[i].g;
        sum[2] += splats.radiance[i].b;
    }
}

void ImageFilm::add_splats_to(std::vector<Rgb>& pixels, std::uint32_t first,
                              std::uint32_t last) const {
    if (splats_.empty()) return;
    const auto passes = double(splat_passes_);
    for (std::size_t p = 0; p < pixels.size(); ++p) {
        for (std::uint32_t g = first; g < last; ++g) {
            const double* sum = &splats_[(p * groups_ + g) * 3];
            pixels[p] += {float(sum[0] / passes), float(sum[1] / passes), float(sum[2] / passes)};
        }
    }
}

void ImageFilm::add_layer_pass(std::string_view name, std::span<const Vec2> positions,
                               std::span<const Rgb> values, double weight) {
    PixelMean& layer = color_layers_.try_emplace(std::string(name), width_, height_).first->second;
    layer.add(positions, values, weight);
}

void ImageFilm::set_layer(std::string_view name, std::span<const float> values) {
    require(values.size(), std::size_t(width_) * height_, "values of pixels in a layer");
    layers_[std::string(name)].assign(values.begin(), values.end());
}

std::vector<Rgb> ImageFilm::image() const {
    std::vector<Rgb> pixels = eye_part();
    photons_.add_to(pixels, 0, groups_);
    return pixels;
}

std::vector<Rgb> ImageFilm::image_of_group(std::uint32_t group) const {
    std::vector<Rgb> pixels(std::size_t(width_) * height_);
    for (const PixelMean* mean : {&eye_, &photons_})
        mean->add_to(pixels, group, group + 1);
    add_splats_to(pixels, group, group + 1);
    return pixels;
}

std::vector<Rgb> ImageFilm::eye_part() const {
    std::vector<Rgb> pixels = eye_.image();
    add_splats_to(pixels, 0, groups_);
    return pixels;
}

double ImageFilm::mean() const {
    return mean_luminance(image());
}

}  // namespace aips
