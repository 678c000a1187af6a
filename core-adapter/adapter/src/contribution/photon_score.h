// What a photon contributes to the image: the sum of its squared contributions to visible points,
// each weighed by how much an error counts there.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "aips/core/photon_map/cell_sort.h"
#include "estimate/gather.h"

namespace aips {

/// Visible points as photons see them; const after build, when it may be used from many threads.
class PhotonScore {
  public:
    /// For the visible points of `image`, whose positions are `positions`; `weights` as
    /// PixelImportance gives them. All but the positions outlive the queries.
    void build(const EyeImage& image, std::span<const Vec3> positions, const GatherRadii& radii,
               std::span<const float> weights);

    /// Q = sum over the visible points within whose radius the photon is of
    /// weight (luminance of the contribution)^2 / (pi r^2), per visible point of the pass. It does
    /// not depend on the radius, on the visible points' number or on photons per pass, in
    /// expectation; it grows with the square of the photon's power.
    double score(const Photon& stored) const {
        return mean(stored, [&](std::size_t point, const GridPhoton& photon, float radius) {
            return term(point, photon, radius);
        });
    }
    /// The same where `term_of` says what a point with a Bsdf adds: term(), of whoever has it.
    template <class TermOf>
    double score_with(const Photon& stored, const TermOf& term_of) const {
        return mean(stored, [&](std::size_t point, const GridPhoton& photon, float radius) {
            return has_bsdf(point) ? term_of(point) : term(point, photon, radius);
        });
    }
    /// Calls visit(point, term) for the points that `wanted` chooses, in the order of the sum.
    template <class Wanted, class Visit>
    void for_each_term(const Photon& stored, const Wanted& wanted, const Visit& visit) const {
        const GridPhoton photon = grid_photon(stored, 0);
        for_each_near(stored, [&](std::size_t point, float radius) {
            if (wanted(point)) visit(point, term(point, photon, radius));
        });
    }
    bool has_bsdf(std::size_t point) const { return image_->visible_points[point].bsdf; }
    const EyeImage& image() const { return *image_; }

    std::size_t memory_bytes() const { return cells_.memory_bytes(); }

  private:
    template <class Visit>
    void for_each_near(const Photon& stored, const Visit& visit) const {
        cells_.for_each_in_radius(stored.position, radii_.largest, [&](std::uint32_t slot) {
            const std::uint32_t i = cells_.order()[slot];
            const float radius = radii_.of(i);
            const Vec3 position = image_->visible_points[i].position;
            if (length_squared(position - stored.position) <= radius * radius) visit(i, radius);
        });
    }
    template <class TermOf>
    double mean(const Photon& stored, const TermOf& term_of) const {
        const GridPhoton photon = grid_photon(stored, 0);
        double sum = 0;
        for_each_near(stored, [&](std::size_t point, float radius) {
            sum += term_of(point, photon, radius);
        });
        const auto points = double(image_->visible_points.size());
        return points > 0 && std::isfinite(sum) ? sum / points : 0;
    }
    /// What a visible point adds to the sum, >= 0.
    double term(std::size_t point, const GridPhoton& photon, float radius) const;

    const EyeImage* image_ = nullptr;
    GatherRadii radii_;
    std::span<const float> weights_;
    CellSort cells_;
};

}  // namespace aips
