// What the radius of photons does to an image, as far as passes tell.
#include "film_bias.h"

#include "finite_float.h"
#include "for_pixels.h"

namespace lxs {
namespace {

/// Of the bias over what half of the disc's area takes away from it.
constexpr double kBiasOverDifference = 2;

PixelFilter own_pixel() {
    return {0.5, 0.5, [](double, double) { return 1.0; }};
}

}  // namespace

FilmBias::FilmBias(std::uint32_t width, std::uint32_t height)
    : discs_(width, height, 1, own_pixel()), halves_(std::size_t{width} * height) {}

void FilmBias::add(const PassSamples& samples) {
    discs_.add(samples);
    brought_ = true;
}

void FilmBias::end_pass() {
    if (!brought_) return;
    brought_ = false;
    schedule_.end_pass();
    if (!schedule_.full()) return;
    halves_.end_batch([this](std::size_t i) { return mean(i); }, false, schedule_.half());
    schedule_.close();
}

void FilmBias::clear() {
    discs_.clear();
    schedule_ = {};
    halves_.clear();
    brought_ = false;
}

PixelMeans FilmBias::mean(std::size_t pixel) const {
    const PixelMeans discs = discs_.means(pixel);
    return {.value = {(discs.value[1] - discs.value[0]) * kBiasOverDifference, Imath::V3d(0.0)},
            .weight = {discs.weight[0], 0}};
}

void FilmBias::values(std::span<Rgb> values) const {
    for_pixels(values.size(), [&](std::size_t i) {
        const Imath::V3d bias = mean(i).value[0];
        values[i] = {finite_float(bias.x), finite_float(bias.y), finite_float(bias.z)};
    });
}

void FilmBias::squares(std::span<Rgb> values) const {
    for_pixels(values.size(), [&](std::size_t i) {
        const Imath::V3d product = halves_.mean(0, i) * halves_.mean(1, i);
        values[i] = {finite_float(product.x), finite_float(product.y), finite_float(product.z)};
    });
}

void FilmBias::state(StateArchive& archive) {
    discs_.state(archive);
    schedule_.state(archive);
    halves_.state(archive);
    archive.value(brought_);
}

}  // namespace lxs
