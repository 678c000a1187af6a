// The samples of a pass by the pixel that they lie in.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "lxs/sdk/film.h"
#include "lxs/sdk/state_archive.h"

namespace lxs {

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

/// Sorts the samples of one pass after the other by the cell (pixel) that each lies in, row by row,
/// within a cell in the order given, so that who sums them in that order gets the same bits for any
/// number of threads. Samples beyond the film's edge are in the nearest cell; those that are not
/// finite or negative are left out whole and counted.
class SampleCells {
  public:
    SampleCells(std::uint32_t width, std::uint32_t height, std::uint32_t groups);

    /// Throws std::invalid_argument if the pass is malformed (sizes, groups, weights): a bug of the
    /// caller. Samples before are forgotten.
    void sort(const PassSamples& pass);

    /// Numbers of the samples in cells [first, last] of a row of them.
    std::span<const std::uint32_t> samples(std::uint32_t row, std::uint32_t first,
                                           std::uint32_t last) const {
        const std::size_t first_cell = std::size_t{row} * width_;
        const std::uint32_t begin = cell_begin_[first_cell + first];
        return std::span(order_).subspan(begin, cell_begin_[first_cell + last + 1] - begin);
    }

    /// Samples refused for what they brought of each light group, each counted once; the last
    /// entry: for their position.
    std::span<const std::uint64_t> refused() const { return refused_; }
    void state_of_refused(StateArchive& archive);
    /// Bytes held at one sample per cell and pass, or more if a pass brought more.
    std::size_t memory_bytes() const;

  private:
    void check(const PassSamples& pass) const;
    void find_cells(const PassSamples& pass);
    std::vector<std::size_t> ranges() const;
    void count(const PassSamples& pass, const std::vector<std::size_t>& begins);
    void sum_counts();
    bool acceptable_radiance(const PassSamples& pass, std::size_t first, std::size_t count) const;
    std::size_t reason_for_refusal(const PassSamples& pass, std::size_t sample) const;

    std::uint32_t width_, height_, groups_;
    std::vector<std::uint64_t> refused_;
    // Kept between passes, so that passes after the first allocate nothing.
    std::vector<std::uint32_t> cell_of_sample_;
    std::vector<std::uint32_t> cell_begin_;  ///< per cell, and the end: index into `order_`
    std::vector<std::uint32_t> order_;       ///< samples by cell
};

}  // namespace lxs
