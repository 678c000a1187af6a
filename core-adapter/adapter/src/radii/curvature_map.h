// What probes have found so far, pixel by pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "aips/core/base/state_archive.h"
#include "aips/core/base/vector.h"
#include "aips/core/radii/optimal_radius.h"

namespace aips {

/// Means over all probes that were placed in a pixel. The caller chooses units in which they are
/// about as large as radiance. Sums are in double precision: of n probes they are off by n 2^-53 at
/// most, relative to the sum of magnitudes.
class CurvatureMap {
  public:
    CurvatureMap(std::uint32_t width, std::uint32_t height);

    std::uint32_t width() const { return width_; }
    /// Number of the pixel at a film position, which is cut to the film.
    std::uint32_t pixel(Vec2 position) const;
    void add(std::uint32_t pixel, const ProbeEstimate& estimate);
    /// Means over the probes in the pixels nearby, at most two rows and columns away for the widest
    /// discs, one for the next, none for the last; all 0 without a probe. Errors are those of the
    /// means, probes being independent.
    ProbeEstimate mean(std::uint32_t pixel) const;

    /// Saves the sums, or restores them into a new map of the same size.
    void state(StateArchive& archive);

    std::size_t memory_bytes() const { return sums_.capacity() * sizeof(Sums); }
    static std::size_t memory_bound_bytes(std::size_t pixels) { return pixels * sizeof(Sums); }

  private:
    struct Sums {
        double probes = 0, second_moment = 0;
        std::array<double, kProbeScales> laplacian{}, error2{};
    };

    std::uint32_t width_, height_;
    std::vector<Sums> sums_;  // [pixel]
};

}  // namespace aips
