// Sums of filtered samples per pixel and light group, over all passes.
#include "film_accumulator.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "for_rows.h"

namespace lxs {
namespace {

/// Adds f times the radiance of all light groups but the first to the sums of all.
void add_other_groups(std::span<const Rgb> radiance, double f, std::span<double> sums) {
    for (std::size_t g = 1; g < radiance.size(); ++g) {
        sums[3 * g] += f * radiance[g].x;
        sums[3 * g + 1] += f * radiance[g].y;
        sums[3 * g + 2] += f * radiance[g].z;
    }
}

}  // namespace

FilmAccumulator::FilmAccumulator(std::uint32_t width, std::uint32_t height, std::uint32_t groups,
                                 const PixelFilter& filter)
    : width_(width),
      height_(height),
      groups_(groups),
      filter_(filter),
      cells_(width, height, groups) {
    first_.sums.resize(std::size_t{width} * height * (1 + 3 * std::size_t{groups}));
}

std::uint64_t FilmAccumulator::refused_samples() const {
    const auto refused = cells_.refused();
    return std::accumulate(refused.begin(), refused.end(), std::uint64_t{0});
}

/// All memory of a pass is taken before it is summed: one that there is no memory for leaves the
/// sums as they were.
void FilmAccumulator::reserve_rows(bool second) {
    row_pixels_.resize(std::size_t{height_} * (1 + (second ? 6 : 3) * std::size_t{groups_}));
}

std::span<double> FilmAccumulator::row_pixel(std::uint32_t y) {
    const std::size_t size = row_pixels_.size() / height_;
    return std::span(row_pixels_).subspan(y * size, size);
}

void FilmAccumulator::gather_pixel(const PassSamples& pass, std::uint32_t x, std::uint32_t y,
                                   std::span<double> pixel) const {
    std::fill(pixel.begin(), pixel.end(), 0.0);
    // Registers for what every film has: sums in memory wait for their own last store.
    double weights = 0;
    Imath::V3d first(0.0), second(0.0);
    const bool has_second = !pass.second_radiance.empty();
    const std::size_t second_begin = 1 + 3 * std::size_t{groups_};
    const CellRange rows(y, filter_.radius_y(), height_);
    const CellRange columns(x, filter_.radius_x(), width_);
    const Vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
        for (const std::uint32_t i : cells_.samples(row, columns.first, columns.last)) {
            const Vec2& p = pass.positions[i];
            const double f = filter_.weight(p.x - centre.x, p.y - centre.y);
            if (f == 0) continue;
            weights += f;
            const std::size_t at = std::size_t{i} * groups_;
            first += Imath::V3d(pass.radiance[at]) * f;
            if (has_second) second += Imath::V3d(pass.second_radiance[at]) * f;
            if (groups_ == 1) continue;
            add_other_groups(pass.radiance.subspan(at, groups_), f, pixel.subspan(1));
            if (has_second)
                add_other_groups(pass.second_radiance.subspan(at, groups_), f,
                                 pixel.subspan(second_begin));
        }
    }
    pixel[0] = weights;
    for (unsigned c = 0; c < 3; ++c) {
        pixel[1 + c] = first[int(c)];
        if (has_second) pixel[second_begin + c] = second[int(c)];
    }
}

/// From sums of values at wavelengths to sums of linear RGB.
void FilmAccumulator::convert(std::span<double> colors) const {
    for (std::uint32_t g = 0; g < groups_; ++g) {
        double* const sums = &colors[3 * std::size_t{g}];
        const Imath::V3d rgb = Imath::V3d(sums[0], sums[1], sums[2]) * *to_rgb_;
        for (int c = 0; c < 3; ++c)
            sums[c] = rgb[c];
    }
}

void FilmAccumulator::add_pixel(Mean& mean, std::size_t index, double weight, double filter_sum,
                                std::span<double> colors) const {
    if (to_rgb_) convert(colors);
    double* const sums = &mean.sums[index * (1 + colors.size())];
    sums[0] += weight * filter_sum;
    for (std::size_t c = 0; c < colors.size(); ++c)
        sums[1 + c] += weight * colors[c];
}

void FilmAccumulator::gather_row(const PassSamples& pass, std::uint32_t y,
                                 std::span<double> pixel) {
    const std::size_t channels = 3 * std::size_t{groups_};
    for (std::uint32_t x = 0; x < width_; ++x) {
        gather_pixel(pass, x, y, pixel);
        const std::size_t index = std::size_t{y} * width_ + x;
        add_pixel(first_, index, pass.weight, pixel[0], pixel.subspan(1, channels));
        if (pass.second_radiance.empty()) continue;
        add_pixel(second_, index, pass.second_weight, pixel[0],
                  pixel.subspan(1 + channels, channels));
    }
}

/// Integral of the filter around a pixel's centre over the film alone.
double FilmAccumulator::filter_on_film(std::uint32_t x, std::uint32_t y) const {
    return filter_integral_->over(x + 0.5, width_ - x - 0.5, y + 0.5, height_ - y - 0.5);
}

void FilmAccumulator::gather_splats(const PassSamples& pass, std::uint32_t y,
                                    std::span<double> pixel) {
    const std::size_t channels = pixel.size() - 1;
    for (std::uint32_t x = 0; x < width_; ++x) {
        const double on_film = filter_on_film(x, y);
        if (!(on_film > 0)) continue;  // as a mean with a sum of weights that isn't positive
        gather_pixel(pass, x, y, pixel);
        if (to_rgb_) convert(pixel.subspan(1));
        double* sums = &splats_[(std::size_t{y} * width_ + x) * channels];
        for (std::size_t c = 0; c < channels; ++c) {
            sums[c] += pixel[c + 1] / on_film;
        }
    }
}

void FilmAccumulator::add(const PassSamples& pass) {
    const bool second = !pass.second_radiance.empty();
    if (second) begin_second();
    reserve_rows(second);
    cells_.sort(pass);
    for_rows(height_, [&](std::uint32_t y) { gather_row(pass, y, row_pixel(y)); });
    if (!to_rgb_) return;
    first_.white_sum += white_of_pass_ * pass.weight;
    first_.weight_sum += pass.weight;
    if (!second) return;
    second_.white_sum += white_of_pass_ * pass.second_weight;
    second_.weight_sum += pass.second_weight;
}

void FilmAccumulator::add_splats(const PassSplats& splats) {
    const PassSamples pass{splats.positions, splats.radiance, splats.groups, splats.samples};
    begin_splats();
    reserve_rows(false);
    cells_.sort(pass);
    for_rows(height_, [&](std::uint32_t y) { gather_splats(pass, y, row_pixel(y)); });
    splat_samples_ += splats.samples;
}

void FilmAccumulator::begin_second() {
    second_.sums.resize(first_.sums.size());
}

void FilmAccumulator::begin_splats() {
    if (filter_integral_) return;
    splats_.resize(std::size_t{width_} * height_ * 3 * groups_);
    filter_integral_.emplace(filter_);
}

void FilmAccumulator::clear() {
    for (Mean* mean : {&first_, &second_}) {
        std::fill(mean->sums.begin(), mean->sums.end(), 0.0);
        mean->white_sum = Imath::V3d(0.0);
        mean->weight_sum = 0;
    }
    std::fill(splats_.begin(), splats_.end(), 0.0);
    splat_samples_ = 0;
}

std::size_t FilmAccumulator::memory_bytes() const {
    const std::size_t rows = std::size_t{height_} * (1 + 3 * std::size_t{groups_});
    const std::size_t sums = first_.sums.capacity() + second_.sums.capacity() + splats_.capacity() +
                             std::max(rows, row_pixels_.capacity());
    return sums * sizeof(double) + cells_.memory_bytes();
}

}  // namespace lxs
