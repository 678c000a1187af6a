// Sums of filtered samples per pixel and light group, over all passes.
#include "film_accumulator.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Mean from sums: the lobes of a filter may be negative, an image may not.
float mean(double sum, double weight) {
    if (!(weight > 0)) return 0;
    return static_cast<float>(
        std::clamp(sum / weight, 0.0, static_cast<double>(std::numeric_limits<float>::max())));
}

}  // namespace

FilmAccumulator::FilmAccumulator(std::uint32_t width, std::uint32_t height, std::uint32_t groups,
                                 const PixelFilter& filter)
    : width_(width),
      height_(height),
      groups_(groups),
      filter_(filter),
      sums_(std::size_t{width} * height * (1 + 3 * std::size_t{groups})) {}

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

void FilmAccumulator::sort_by_cell() {
    // Stable counting sort; cell_begin_[c + 1] counts and becomes the next free place of cell c.
    const std::size_t cells = std::size_t{width_} * height_;
    cell_begin_.assign(cells + 2, 0);
    for (const std::uint32_t cell : cell_of_sample_) {
        if (cell == kRefused) {
            ++refused_;
        } else {
            ++cell_begin_[cell + 2];
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

void FilmAccumulator::gather_row(const PassSamples& pass, std::uint32_t y,
                                 std::span<double> pixel) {
    const CellRange rows(y, filter_.radius_y(), height_);
    for (std::uint32_t x = 0; x < width_; ++x) {
        std::fill(pixel.begin(), pixel.end(), 0.0);
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
                pixel[0] += f;
                const Rgb* radiance = &pass.radiance[std::size_t{i} * groups_];
                for (std::uint32_t g = 0; g < groups_; ++g) {
                    pixel[3 * g + 1] += f * radiance[g].x;
                    pixel[3 * g + 2] += f * radiance[g].y;
                    pixel[3 * g + 3] += f * radiance[g].z;
                }
            }
        }
        double* sums = &sums_[(std::size_t{y} * width_ + x) * pixel.size()];
        for (std::size_t c = 0; c < pixel.size(); ++c) {
            sums[c] += pass.weight * pixel[c];
        }
    }
}

void FilmAccumulator::add(const PassSamples& pass) {
    check(pass);
    find_cells(pass);
    sort_by_cell();
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, height_), [&](const auto& rows) {
        std::vector<double> pixel(1 + 3 * std::size_t{groups_});
        for (std::uint32_t y = rows.begin(); y != rows.end(); ++y) {
            gather_row(pass, y, pixel);
        }
    });
}

void FilmAccumulator::clear() {
    std::fill(sums_.begin(), sums_.end(), 0.0);
}

void FilmAccumulator::resolve_group(std::uint32_t group, std::span<Rgb> image) const {
    const std::size_t stride = 1 + 3 * std::size_t{groups_};
    for (std::size_t i = 0; i < image.size(); ++i) {
        const double* pixel = &sums_[i * stride];
        const double* sum = pixel + 1 + 3 * std::size_t{group};
        image[i] = Rgb(mean(sum[0], *pixel), mean(sum[1], *pixel), mean(sum[2], *pixel));
    }
}

void FilmAccumulator::resolve_total(std::span<Rgb> image) const {
    const std::size_t stride = 1 + 3 * std::size_t{groups_};
    for (std::size_t i = 0; i < image.size(); ++i) {
        const double* pixel = &sums_[i * stride];
        double total[3] = {0, 0, 0};
        for (std::size_t c = 0; c + 1 < stride; ++c) {
            total[c % 3] += pixel[1 + c];
        }
        image[i] = Rgb(mean(total[0], *pixel), mean(total[1], *pixel), mean(total[2], *pixel));
    }
}

std::size_t FilmAccumulator::memory_bytes() const {
    const std::size_t cells = std::size_t{width_} * height_;
    const std::size_t samples = std::max(cells, cell_of_sample_.capacity());
    return sums_.capacity() * sizeof(double) + (cells + 2 + 2 * samples) * sizeof(std::uint32_t);
}

}  // namespace lxs
