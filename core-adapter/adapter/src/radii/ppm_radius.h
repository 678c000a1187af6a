// The radii of progressive photon mapping: one per frozen visible point, shrinking with the photons
// that it accepts.
//
// Source: Hachisuka, Ogaki & Jensen 2008, "Progressive photon mapping", sections 4.1-4.3. There a
// point keeps tau, the flux within its present radius R over all passes, and the image is
// tau / (pi R^2 N) with N the paths shot so far. Shrinking scales tau by the same share as R^2
// (eq. 10), so that tau / R^2 stays, and each pass adds its flux / R^2 with the radius it searched:
//
//     tau_n / (pi R_n^2 N) = 1/N sum over passes i of flux_i / (pi R_i^2),
//
// which is the mean over passes, by paths shot, of their own estimates. The film takes just that
// mean; the eye paths' own light has another, of which it is a constant. Thus no flux is kept here:
// a point's statistics are its radius and its photon count, whatever the light groups. Both are in
// double precision: late passes shrink R by less than a float can tell from nothing.
#pragma once

#include <vector>

#include "radii/radius_policy.h"

namespace aips {

class PpmRadius final : public RadiusPolicy {
  public:
    PpmRadius(const Settings& settings, const Scene& scene) : settings_(settings), floor_(scene) {}

    GatherRadii before_pass(const PassPhotons& photons, const EyeImage& image) override;
    void after_pass(const PhotonFlux& flux) override;
    void state(StateArchive& archive, const EyeImage& image) override;
    std::size_t memory_bytes() const override {
        return radii_.capacity() * sizeof(float) + points_.capacity() * sizeof(Point);
    }
    /// Upper bound of memory_bytes() for so many visible points.
    static std::size_t memory_bound_bytes(std::size_t visible_points) {
        return visible_points * (sizeof(float) + sizeof(Point));
    }

  private:
    struct Point {
        double photons = 0;         // N of eq. 7, photons kept so far
        double squared_radius = 0;  // R^2
    };

    Settings settings_;
    RadiusFloor floor_;
    std::vector<float> radii_;   // [visible point]: R, as searched
    std::vector<Point> points_;  // [visible point]
};

}  // namespace aips
