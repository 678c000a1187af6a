// Sums and weights of every pixel.
#include "aips/parts/image_film.h"

#include <algorithm>
#include <stdexcept>

namespace aips {

ImageFilm::ImageFilm(std::uint32_t width, std::uint32_t height, std::uint32_t groups)
    : width_(width), height_(height), groups_(groups) {
    for (Mean* mean : {&eye_, &photons_}) {
        mean->sums.resize(std::size_t(width) * height * groups * 3);
        mean->weights.resize(std::size_t(width) * height);
    }
}

void ImageFilm::add_pass(const FilmPass& pass) {
    add(eye_, pass.positions, pass.eye, 1);
    if (!pass.photons.empty()) add(photons_, pass.positions, pass.photons, pass.photon_weight);
    photon_weights_.push_back(pass.photon_weight);
}

void ImageFilm::add(Mean& mean, std::span<const Vec2> positions, std::span<const Rgb> radiance,
                    double weight) const {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const auto x = std::min(width_ - 1, static_cast<std::uint32_t>(positions[i].x));
        const auto y = std::min(height_ - 1, static_cast<std::uint32_t>(positions[i].y));
        const std::size_t pixel = std::size_t(y) * width_ + x;
        mean.weights[pixel] += weight;
        for (std::uint32_t g = 0; g < groups_; ++g) {
            const Rgb& value = radiance[i * groups_ + g];
            double* sum = &mean.sums[(pixel * groups_ + g) * 3];
            sum[0] += weight * value.r;
            sum[1] += weight * value.g;
            sum[2] += weight * value.b;
        }
    }
}

void ImageFilm::add_layer_pass(std::string_view name, std::span<const Vec2> positions,
                               std::span<const Rgb> values, double weight) {
    ImageFilm& layer = color_layers_.try_emplace(std::string(name), width_, height_).first->second;
    layer.add(layer.eye_, positions, values, weight);
}

void ImageFilm::set_layer(std::string_view name, std::span<const float> values) {
    if (values.size() != eye_.weights.size()) {
        throw std::invalid_argument("ImageFilm: a layer has one value for each pixel");
    }
    layers_[std::string(name)].assign(values.begin(), values.end());
}

std::vector<Rgb> ImageFilm::image() const {
    std::vector<Rgb> pixels(std::size_t(width_) * height_);
    for (const Mean* mean : {&eye_, &photons_})
        add_to_image(*mean, 0, groups_, pixels);
    return pixels;
}

std::vector<Rgb> ImageFilm::image_of_group(std::uint32_t group) const {
    std::vector<Rgb> pixels(std::size_t(width_) * height_);
    for (const Mean* mean : {&eye_, &photons_})
        add_to_image(*mean, group, group + 1, pixels);
    return pixels;
}

std::vector<Rgb> ImageFilm::eye_part() const {
    std::vector<Rgb> pixels(std::size_t(width_) * height_);
    add_to_image(eye_, 0, groups_, pixels);
    return pixels;
}

/// Light groups [first, last).
void ImageFilm::add_to_image(const Mean& mean, std::uint32_t first, std::uint32_t last,
                             std::vector<Rgb>& pixels) const {
    for (std::size_t p = 0; p < pixels.size(); ++p) {
        const double weight = mean.weights[p];
        if (!(weight > 0)) continue;
        for (std::uint32_t g = first; g < last; ++g) {
            const double* sum = &mean.sums[(p * groups_ + g) * 3];
            pixels[p] += {float(sum[0] / weight), float(sum[1] / weight), float(sum[2] / weight)};
        }
    }
}

double ImageFilm::mean() const {
    double sum = 0;
    const std::vector<Rgb> pixels = image();
    for (const Rgb& pixel : pixels)
        sum += luminance(pixel);
    return sum / double(pixels.size());
}

}  // namespace aips
