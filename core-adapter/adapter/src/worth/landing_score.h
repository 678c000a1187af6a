// What a landing is worth to the image: the sum of its squared contributions to visible points,
// each weighed by how much an error counts there.
#pragma once

#include <span>
#include <vector>

#include "aips/core/photon_map/cell_sort.h"
#include "estimate/gather.h"

namespace aips {

/// Visible points as landings see them; const after build, when it may be used from many threads.
class LandingScore {
  public:
    /// For the visible points of `image`, whose positions are `positions`; `weights` as
    /// PixelImportance gives them. All but the positions outlive the queries.
    void build(const EyeImage& image, std::span<const Vec3> positions, const SearchRadii& radii,
               std::span<const float> weights);

    /// Q = sum over the visible points within whose radius the landing is of
    /// weight (luminance of the contribution)^2 / (pi r^2), per visible point of the pass. It does
    /// not depend on the radius, on the visible points' number or on photons per pass, in
    /// expectation; it grows with the square of the landing's power.
    double score(const Landing& landing) const;

    std::size_t memory_bytes() const { return cells_.memory_bytes(); }

  private:
    const EyeImage* image_ = nullptr;
    SearchRadii radii_;
    std::span<const float> weights_;
    CellSort cells_;
};

}  // namespace aips
