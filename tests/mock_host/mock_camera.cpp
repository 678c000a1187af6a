// Camera, sampler and film of the mock host.
#include "mock_camera.h"

#include <stdexcept>

#include "aips/core/random.h"

namespace mock {

using namespace aips;

CameraRay Camera::generate(const CameraSample& sample, float time) const {
    const float x = 2 * sample.film.x / float(width_) - 1;
    const float y = 2 * sample.film.y / float(height_) - 1;
    CameraRay ray;
    ray.ray = {eye_, normalize(forward_ + right_ * x + down_ * y), time, nullptr};
    ray.spread = length(right_) / float(width_);
    return ray;
}

CameraSample Sampler::camera_sample(std::uint64_t number, std::uint32_t x, std::uint32_t y) const {
    RandomStream random(seed_, number, y * 65536u + x, RandomDomain::Eye);
    const Vec2 u = random.next2();
    return {{float(x) + u.x, float(y) + u.y}, random.next2()};
}

Film::Film(std::uint32_t width, std::uint32_t height, std::uint32_t groups)
    : width_(width), height_(height), groups_(groups) {
    for (Mean* mean : {&eye_, &photons_}) {
        mean->sums.resize(std::size_t(width) * height * groups * 3);
        mean->weights.resize(std::size_t(width) * height);
    }
}

void Film::add_pass(const FilmPass& pass) {
    add(eye_, pass.positions, pass.eye, 1);
    if (!pass.photons.empty()) add(photons_, pass.positions, pass.photons, pass.photon_weight);
    photon_weights_.push_back(pass.photon_weight);
}

void Film::add(Mean& mean, std::span<const Vec2> positions, std::span<const Rgb> radiance,
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

void Film::add_layer_pass(std::string_view name, std::span<const Vec2> positions,
                          std::span<const Rgb> values, double weight) {
    Film& layer = color_layers_.try_emplace(std::string(name), width_, height_).first->second;
    layer.add(layer.eye_, positions, values, weight);
}

void Film::set_layer(std::string_view name, std::span<const float> values) {
    if (values.size() != eye_.weights.size()) throw std::invalid_argument("mock film: layer size");
    layers_[std::string(name)].assign(values.begin(), values.end());
}

std::vector<Rgb> Film::image(int group) const {
    std::vector<Rgb> pixels(std::size_t(width_) * height_);
    for (const Mean* mean : {&eye_, &photons_})
        add_to_image(*mean, group, pixels);
    return pixels;
}

std::vector<Rgb> Film::eye_part() const {
    std::vector<Rgb> pixels(std::size_t(width_) * height_);
    add_to_image(eye_, -1, pixels);
    return pixels;
}

void Film::add_to_image(const Mean& mean, int group, std::vector<Rgb>& pixels) const {
    for (std::size_t p = 0; p < pixels.size(); ++p) {
        const double weight = mean.weights[p];
        for (std::uint32_t g = 0; g < groups_; ++g) {
            if ((group >= 0 && g != std::uint32_t(group)) || !(weight > 0)) continue;
            const double* sum = &mean.sums[(p * groups_ + g) * 3];
            pixels[p] += {float(sum[0] / weight), float(sum[1] / weight), float(sum[2] / weight)};
        }
    }
}

double Film::mean() const {
    double sum = 0;
    const std::vector<Rgb> pixels = image();
    for (const Rgb& pixel : pixels)
        sum += luminance(pixel);
    return sum / double(pixels.size());
}

}  // namespace mock
