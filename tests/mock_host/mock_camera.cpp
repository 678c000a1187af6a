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
    : width_(width),
      height_(height),
      groups_(groups),
      sums_(std::size_t(width) * height * groups * 3),
      weights_(std::size_t(width) * height) {}

void Film::add_pass(std::span<const Vec2> positions, std::span<const Rgb> radiance,
                    std::uint32_t groups, double weight) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const auto x = std::min(width_ - 1, static_cast<std::uint32_t>(positions[i].x));
        const auto y = std::min(height_ - 1, static_cast<std::uint32_t>(positions[i].y));
        const std::size_t pixel = std::size_t(y) * width_ + x;
        weights_[pixel] += weight;
        for (std::uint32_t g = 0; g < groups; ++g) {
            const Rgb& value = radiance[i * groups + g];
            double* sum = &sums_[(pixel * groups_ + g) * 3];
            sum[0] += weight * value.r;
            sum[1] += weight * value.g;
            sum[2] += weight * value.b;
        }
    }
    pass_weights_.push_back(weight);
}

void Film::add_layer_pass(std::string_view name, std::span<const Vec2> positions,
                          std::span<const Rgb> values, double weight) {
    color_layers_.try_emplace(std::string(name), width_, height_)
        .first->second.add_pass(positions, values, 1, weight);
}

void Film::set_layer(std::string_view name, std::span<const float> values) {
    if (values.size() != weights_.size()) throw std::invalid_argument("mock film: layer size");
    layers_[std::string(name)].assign(values.begin(), values.end());
}

std::vector<Rgb> Film::image(int group) const {
    std::vector<Rgb> pixels(weights_.size());
    for (std::size_t p = 0; p < pixels.size(); ++p) {
        for (std::uint32_t g = 0; g < groups_; ++g) {
            if ((group >= 0 && g != std::uint32_t(group)) || !(weights_[p] > 0)) continue;
            const double* sum = &sums_[(p * groups_ + g) * 3];
            pixels[p] += {float(sum[0] / weights_[p]), float(sum[1] / weights_[p]),
                          float(sum[2] / weights_[p])};
        }
    }
    return pixels;
}

double Film::mean() const {
    double sum = 0;
    const std::vector<Rgb> pixels = image();
    for (const Rgb& pixel : pixels)
        sum += luminance(pixel);
    return sum / double(pixels.size());
}

}  // namespace mock
