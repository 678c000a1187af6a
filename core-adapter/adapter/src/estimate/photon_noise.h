// How sure the image is, place by place, of what photons have brought so far.
#pragma once

#include <cstdint>
#include <vector>

#include "aips/core/base/state_archive.h"
#include "base/constants.h"
#include "estimate/constants.h"
#include "estimate/gather.h"

namespace aips {

/// Relative variances of the photons' mean over passes, for cells of kFilmCell x kFilmCell
/// pixels: one pixel alone would not know of rare bright photons that only its neighbours got.
class PhotonNoise {
  public:
    PhotonNoise(std::uint32_t width, std::uint32_t height);

    /// Adds what the photons of a pass have brought.
    void add_pass(const EyeImage& image, const PhotonFlux& flux);

    /// Relative variance, by the passes added, of a pixel in the cell of this one, photons coming
    /// one by one: 1 / (their number) where all bring the same. Infinite where none has come.
    double relative_variance(std::uint32_t pixel) const;

    /// Saves the sums, or restores them into a new one for the same film.
    void state(StateArchive& archive);

    std::size_t memory_bytes() const { return cells_.capacity() * sizeof(Cell); }
    /// Films one pixel wide have the most cells.
    static std::size_t memory_bound_bytes(std::size_t pixels) {
        return (pixels + kFilmCell - 1) / kFilmCell * sizeof(Cell);
    }

  private:
    /// Of full cells; at the film's edge variances are overstated. In double precision: of n
    /// visible points they are off by n 2^-53 at most.
    struct Cell {
        double sum = 0, squares = 0;  // of luminances, of those of single photons
    };

    std::uint32_t width_, height_;
    std::vector<Cell> cells_;
};

}  // namespace aips
