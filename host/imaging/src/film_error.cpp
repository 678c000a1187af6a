// What a film knows of its own error.
#include "film_error.h"

#include <algorithm>
#include <cmath>

#include "finite_float.h"
#include "for_pixels.h"
#include "lxs/imaging/error_figures.h"

namespace lxs {
namespace {

/// Variance of what the image shows: a mean below zero, where negative lobes of the filter have
/// drawn it, is shown as zero, and zero is nearly always what is true there.
double variance_shown(double mean, double variance) {
    if (mean >= 0) return variance;
    const double above = std::sqrt(variance) + mean;
    return above > 0 ? above * above : 0;
}

}  // namespace

FilmError::FilmError(std::uint32_t width, std::uint32_t height)
    : width_(width), height_(height), variance_(pixels()) {}

void FilmError::add(const PassSamples& samples) {
    const double per_pixel =
        static_cast<double>(samples.positions.size()) / static_cast<double>(pixels());
    pass_[0] += samples.weight * per_pixel;
    if (!samples.second_radiance.empty()) pass_[1] += samples.second_weight * per_pixel;
}

void FilmError::add(const PassSplats& splats) {
    pass_splats_ += splats.samples / static_cast<double>(pixels());
}

void FilmError::end_pass(const FilmAccumulator& film) {
    // Where there are samples, splats are of the same passes.
    if (pass_[0] == 0) pass_[0] = pass_splats_;
    variance_.end_pass(film, pass_);
    pass_ = {};
    pass_splats_ = 0;
}

void FilmError::clear() {
    variance_.clear();
    pass_ = {};
    pass_splats_ = 0;
}

std::optional<ErrorEstimate> FilmError::estimate(const FilmAccumulator& film,
                                                 const FilmBias* bias) const {
    if (!known()) return std::nullopt;
    UncertainImage image{.width = width_, .height = height_};
    image.value.resize(pixels());
    image.variance.resize(pixels());
    for_pixels(pixels(), [&](std::size_t i) {
        const PixelMeans now = film.means(i);
        const Imath::V3d variance = variance_.variance(i, now);
        const Imath::V3d mean = now.value[0] + now.value[1];
        for (int c = 0; c < 3; ++c) {
            image.value[i][c] = finite_float(std::max(mean[c], 0.0));
            image.variance[i][c] = finite_float(variance_shown(mean[c], variance[c]));
        }
    });
    image.degrees_of_freedom = variance_.batches().degrees_of_freedom();
    if (bias && bias->known()) {
        image.squared_bias.resize(pixels());
        bias->squares(image.squared_bias);
    }
    ErrorEstimate estimate = estimate_error(image);
    estimate.passes = variance_.batches().passes();
    return estimate;
}

void FilmError::standard_errors(const FilmAccumulator& film, std::span<Rgb> values) const {
    for_pixels(pixels(), [&](std::size_t i) {
        const Imath::V3d variance = variance_.variance(i, film.means(i));
        for (int c = 0; c < 3; ++c)
            values[i][c] = finite_float(std::sqrt(variance[c]));
    });
}

void FilmError::state(StateArchive& archive) {
    variance_.state(archive);
}

}  // namespace lxs
