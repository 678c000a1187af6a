// Sums of filtered samples per pixel and light group, over all passes.
#include "film_accumulator.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace lxs {
namespace {

constexpr std::uint32_t kRefused = std::numeric_limits<std::uint32_t>::max();

bool acceptable(float value) {
    return value >= 0 && value <= std::numeric_limits<float>::max();  // false for NaN
}

bool acceptable(std::span<const Rgb> radiance) {
    return std::all_of(radiance.begin(), radiance.end(), [](const Rgb& c) {
        return acceptable(c.x) && acceptable(c.y) && acceptable(c.z);
    });
}

std::uint32_t cell_index(float position, std::uint32_t size) {
    return static_cast<std::uint32_t>(std::clamp(position, 0.0f, static_cast<float>(size - 1)));
}

/// Cells [first, last] that a filter of this radius around the centre of pixel `i` reaches.
struct CellRange {
    std::uint32_t first, last;

    CellRange(std::uint32_t i, float radius, std::uint32_t size) {
        const float centre = static_cast<float>(i) + 0.5f;
        const float end = static_cast<float>(size - 1);
        first = static_cast<std::uint32_t>(std::clamp(std::floor(centre - radius), 0.0f, end));
        last = static_cast<std::uint32_t>(std::clamp(std::ceil(centre + radius) - 1, 0.0f, end));
    }
};

}  // namespace

FilmAccumulator::FilmAccumulator(std::uint32_t width, std::uint32_t height, std::uint32_t groups,
                                 const PixelFilter& filter)
    : width_(width),
      height_(height),
      groups_(groups),
      filter_(filter),
      sums_(std::size_t{width} * height * (1 + 3 * std::size_t{groups})),
      refused_(std::size_t{groups} + 1) {}

void FilmAccumulator::check(const PassSamples& pass) const {
    if (pass.groups != groups_ || pass.radiance.size() != pass.positions.size() * groups_) {
        throw std::invalid_argument("film: radiance doesn't match positions and light groups");
    }
    if (!(pass.weight > 0) || !std::isfinite(pass.weight)) {
        throw std::invalid_argument("film: the weight of a pass must be finite and positive");
    }
    if (pass.positions.size() >= kRefused) {
        throw std::invalid_argument("film: a pass has more than 2^32 - 2 samples");
    }
}

void FilmAccumulator::find_cells(const PassSamples& pass) {
    cell_of_sample_.resize(pass.positions.size());
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, pass.positions.size(), 4096), [&](const auto& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i) {
                const Vec2& p = pass.positions[i];
                const bool good = std::isfinite(p.x) && std::isfinite(p.y) &&
                                  acceptable(pass.radiance.subspan(i * groups_, groups_));
                cell_of_sample_[i] =
                    good ? cell_index(p.y, height_) * width_ + cell_index(p.x, width_) : kRefused;
            }
        });
}

/// The first group whose radiance can't be taken, or the number of groups: its position can't.
std::size_t FilmAccumulator::reason_for_refusal(const PassSamples& pass, std::size_t sample) const {
    for (std::size_t g = 0; g < groups_; ++g) {
        if (!acceptable(pass.radiance.subspan(sample * groups_ + g, 1))) return g;
    }
    return groups_;
}

std::uint64_t FilmAccumulator::refused_samples() const {
    return std::accumulate(refused_.begin(), refused_.end(), std::uint64_t{0});
}

void FilmAccumulator::sort_by_cell(const PassSamples& pass) {
    // Stable counting sort; cell_begin_[c + 1] counts and becomes the next free place of cell c.
    const std::size_t cells = std::size_t{width_} * height_;
    cell_begin_.assign(cells + 2, 0);
    for (std::size_t i = 0; i < cell_of_sample_.size(); ++i) {
        if (cell_of_sample_[i] == kRefused) {
            ++refused_[reason_for_refusal(pass, i)];
        } else {
            ++cell_begin_[cell_of_sample_[i] + 2];
        }
    }
    for (std::size_t c = 2; c < cells + 2; ++c) {
        cell_begin_[c] += cell_begin_[c - 1];
    }
    order_.resize(cell_begin_.back());
    for (std::uint32_t i = 0; i < cell_of_sample_.size(); ++i) {
        if (cell_of_sample_[i] != kRefused) order_[cell_begin_[cell_of_sample_[i] + 1]++] = i;
    }
}

/// All memory of a pass is taken before it is summed: one that there is no memory for leaves the
/// sums as they were.
void FilmAccumulator::reserve_rows() {
    row_pixels_.resize(std::size_t{height_} * (1 + 3 * std::size_t{groups_}));
}

std::span<double> FilmAccumulator::row_pixel(std::uint32_t y) {
    const std::size_t size = 1 + 3 * std::size_t{groups_};
    return std::span(row_pixels_).subspan(y * size, size);
}

void FilmAccumulator::gather_pixel(const PassSamples& pass, std::uint32_t x, std::uint32_t y,
                                   std::span<double> pixel) const {
    std::fill(pixel.begin(), pixel.end(), 0.0);
    // Registers for what every film has: sums in memory wait for their own last store.
    double weights = 0;
    Imath::V3d first_group(0.0);
    const CellRange rows(y, filter_.radius_y(), height_);
    const CellRange columns(x, filter_.radius_x(), width_);
    const Vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
        const std::size_t first_cell = std::size_t{row} * width_;
        const std::uint32_t end = cell_begin_[first_cell + columns.last + 1];
        for (std::uint32_t k = cell_begin_[first_cell + columns.first]; k < end; ++k) {
            const std::uint32_t i = order_[k];
            const Vec2& p = pass.positions[i];
            const double f = filter_.weight(p.x - centre.x, p.y - centre.y);
            if (f == 0) continue;
            weights += f;
            const Rgb* radiance = &pass.radiance[std::size_t{i} * groups_];
            first_group += Imath::V3d(*radiance) * f;
            for (std::uint32_t g = 1; g < groups_; ++g) {
                pixel[3 * g + 1] += f * radiance[g].x;
                pixel[3 * g + 2] += f * radiance[g].y;
                pixel[3 * g + 3] += f * radiance[g].z;
            }
        }
    }
    pixel[0] = weights;
    for (int c = 0; c < 3; ++c) {
        pixel[1 + static_cast<std::size_t>(c)] = first_group[c];
    }
}

/// From sums of values at wavelengths to sums of linear RGB.
void FilmAccumulator::convert(std::span<double> pixel) const {
    for (std::uint32_t g = 0; g < groups_; ++g) {
        double* const sums = &pixel[3 * std::size_t{g} + 1];
        const Imath::V3d rgb = Imath::V3d(sums[0], sums[1], sums[2]) * *to_rgb_;
        for (int c = 0; c < 3; ++c)
            sums[c] = rgb[c];
    }
}

/// What a white of 1 is in the mean over the passes; 1 but for the choice of wavelengths. Never
/// so little that a pixel is blown up where a pass saw one end of the spectrum alone.
Imath::V3d FilmAccumulator::white() const {
    constexpr double kLeast = 0.25;
    if (!(weight_sum_ > 0)) return Imath::V3d(1.0);
    const Imath::V3d mean = white_sum_ / weight_sum_;
    return {std::max(mean.x, kLeast), std::max(mean.y, kLeast), std::max(mean.z, kLeast)};
}

void FilmAccumulator::gather_row(const PassSamples& pass, std::uint32_t y,
                                 std::span<double> pixel) {
    for (std::uint32_t x = 0; x < width_; ++x) {
        gather_pixel(pass, x, y, pixel);
        if (to_rgb_) convert(pixel);
        double* sums = &sums_[(std::size_t{y} * width_ + x) * pixel.size()];
        for (std::size_t c = 0; c < pixel.size(); ++c) {
            sums[c] += pass.weight * pixel[c];
        }
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
        double* sums = &splats_[(std::size_t{y} * width_ + x) * channels];
        for (std::size_t c = 0; c < channels; ++c) {
            sums[c] += pixel[c + 1] / on_film;
        }
    }
}

void FilmAccumulator::add(const PassSamples& pass) {
    check(pass);
    find_cells(pass);
    sort_by_cell(pass);
    reserve_rows();
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, height_), [&](const auto& rows) {
        for (std::uint32_t y = rows.begin(); y != rows.end(); ++y) {
            gather_row(pass, y, row_pixel(y));
        }
    });
    if (!to_rgb_) return;
    white_sum_ += white_of_pass_ * pass.weight;
    weight_sum_ += pass.weight;
}

void FilmAccumulator::add_splats(const PassSplats& splats) {
    const PassSamples pass{splats.positions, splats.radiance, splats.groups, splats.samples};
    check(pass);
    begin_splats();
    find_cells(pass);
    sort_by_cell(pass);
    reserve_rows();
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, height_), [&](const auto& rows) {
        for (std::uint32_t y = rows.begin(); y != rows.end(); ++y) {
            gather_splats(pass, y, row_pixel(y));
        }
    });
    splat_samples_ += splats.samples;
}

void FilmAccumulator::begin_splats() {
    if (filter_integral_) return;
    filter_integral_.emplace(filter_);
    splats_.resize(std::size_t{width_} * height_ * 3 * groups_);
}

void FilmAccumulator::state(StateArchive& archive) {
    check_size(archive);
    archive.fixed(sums_);
    bool has_splats = filter_integral_.has_value();
    archive.value(has_splats);
    if (has_splats) {
        begin_splats();
        archive.fixed(splats_);
    }
    archive.value(splat_samples_);
    for (double* sum : {&white_sum_.x, &white_sum_.y, &white_sum_.z, &weight_sum_})
        archive.value(*sum);
    archive.fixed(refused_);
    if (archive.restoring()) check_sums();
}

/// Films of 7 x 5 and of 5 x 7 pixels have equally many sums.
void FilmAccumulator::check_size(StateArchive& archive) const {
    std::array<std::uint32_t, 3> size{width_, height_, groups_};
    archive.fixed(std::span(size));
    if (size != std::array<std::uint32_t, 3>{width_, height_, groups_})
        throw StateError("it is of a film of another size");
}

void FilmAccumulator::check_sums() const {
    const auto finite = [](double sum) { return std::isfinite(sum); };
    const bool sound = std::all_of(sums_.begin(), sums_.end(), finite) &&
                       std::all_of(splats_.begin(), splats_.end(), finite) &&
                       finite(splat_samples_) && splat_samples_ >= 0 && finite(white_sum_.x) &&
                       finite(white_sum_.y) && finite(white_sum_.z) && finite(weight_sum_);
    if (!sound) throw StateError("a sum of the film is no finite number");
}

void FilmAccumulator::clear() {
    std::fill(sums_.begin(), sums_.end(), 0.0);
    std::fill(splats_.begin(), splats_.end(), 0.0);
    splat_samples_ = 0;
    white_sum_ = Imath::V3d(0.0);
    weight_sum_ = 0;
}

/// A pixel's value summed over light groups: the mean of samples, and the splats.
Rgb FilmAccumulator::resolve(std::size_t pixel, std::uint32_t first_group,
                             std::uint32_t end_group) const {
    const std::size_t channels = 3 * std::size_t{groups_};
    const double* sums = &sums_[pixel * (1 + channels)];
    const double pixels = static_cast<double>(width_) * height_;
    const Imath::V3d white = this->white();
    Rgb value;
    for (std::size_t c = 0; c < 3; ++c) {
        double mean = 0, splats = 0;
        for (std::size_t g = first_group; g < end_group; ++g) {
            mean += sums[1 + 3 * g + c];
            if (!splats_.empty()) splats += splats_[pixel * channels + 3 * g + c];
        }
        mean = *sums > 0 ? mean / (*sums * white[static_cast<int>(c)]) : 0;
        if (splat_samples_ > 0) mean += splats * pixels / splat_samples_;
        // The lobes of a filter may be negative, an image may not.
        value[static_cast<int>(c)] = static_cast<float>(
            std::clamp(mean, 0.0, static_cast<double>(std::numeric_limits<float>::max())));
    }
    return value;
}

void FilmAccumulator::resolve_group(std::uint32_t group, std::span<Rgb> image) const {
    for (std::size_t i = 0; i < image.size(); ++i)
        image[i] = resolve(i, group, group + 1);
}

void FilmAccumulator::resolve_total(std::span<Rgb> image) const {
    for (std::size_t i = 0; i < image.size(); ++i)
        image[i] = resolve(i, 0, groups_);
}

std::size_t FilmAccumulator::memory_bytes() const {
    const std::size_t cells = std::size_t{width_} * height_;
    const std::size_t samples = std::max(cells, cell_of_sample_.capacity());
    const std::size_t rows = std::size_t{height_} * (1 + 3 * std::size_t{groups_});
    return (sums_.capacity() + splats_.capacity() + rows) * sizeof(double) +
           (cells + 2 + 2 * samples) * sizeof(std::uint32_t);
}

}  // namespace lxs
