// The samples of a pass by the pixel that they lie in.
#include "sample_cells.h"

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

bool is_weight(double weight) {
    return weight > 0 && std::isfinite(weight);
}

}  // namespace

SampleCells::SampleCells(std::uint32_t width, std::uint32_t height, std::uint32_t groups)
    : width_(width), height_(height), groups_(groups), refused_(std::size_t{groups} + 1) {}

void SampleCells::check(const PassSamples& pass) const {
    const std::size_t values = pass.positions.size() * groups_;
    const std::size_t second = pass.second_radiance.size();
    if (pass.groups != groups_ || pass.radiance.size() != values ||
        (second != values && second != 0)) {
        throw std::invalid_argument("film: radiance doesn't match positions and light groups");
    }
    if (!is_weight(pass.weight) || !is_weight(pass.second_weight)) {
        throw std::invalid_argument("film: the weight of a pass must be finite and positive");
    }
    if (pass.positions.size() >= kRefused) {
        throw std::invalid_argument("film: a pass has more than 2^32 - 2 samples");
    }
}

/// Of `count` values from the `first` one on, in both parts.
bool SampleCells::acceptable_radiance(const PassSamples& pass, std::size_t first,
                                      std::size_t count) const {
    return acceptable(pass.radiance.subspan(first, count)) &&
           (pass.second_radiance.empty() || acceptable(pass.second_radiance.subspan(first, count)));
}

void SampleCells::find_cells(const PassSamples& pass) {
    cell_of_sample_.resize(pass.positions.size());
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, pass.positions.size(), 4096), [&](const auto& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i) {
                const Vec2& p = pass.positions[i];
                const bool good = std::isfinite(p.x) && std::isfinite(p.y) &&
                                  acceptable_radiance(pass, i * groups_, groups_);
                cell_of_sample_[i] =
                    good ? cell_index(p.y, height_) * width_ + cell_index(p.x, width_) : kRefused;
            }
        });
}

/// The first group whose radiance can't be taken, or the number of groups: its position can't.
std::size_t SampleCells::reason_for_refusal(const PassSamples& pass, std::size_t sample) const {
    for (std::size_t g = 0; g < groups_; ++g) {
        if (!acceptable_radiance(pass, sample * groups_ + g, 1)) return g;
    }
    return groups_;
}

void SampleCells::sort(const PassSamples& pass) {
    check(pass);
    find_cells(pass);
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

void SampleCells::state_of_refused(StateArchive& archive) {
    archive.fixed(refused_);
}

std::size_t SampleCells::memory_bytes() const {
    const std::size_t cells = std::size_t{width_} * height_;
    const std::size_t samples = std::max(cells, cell_of_sample_.capacity());
    return (cells + 2 + 2 * samples) * sizeof(std::uint32_t);
}

}  // namespace lxs
