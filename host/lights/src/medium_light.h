// The light that a medium sends by itself: a flame, glowing gas.
#pragma once

#include "cell_choice.h"
#include "lxs/lights/lights.h"
#include "lxs/sdk/grid_walk.h"

namespace lxs {

/// Shines by every point of a volume. Directions from a place are those to points that are drawn in
/// proportion to what the cells of a grid send; the light along such a line is then asked at
/// another of its points. So the distance's square, which is in the density of directions by all
/// points of the line together (and in closed form), divides no value: light is as bounded beside
/// and within the medium as far away from it.
class MediumLight final : public PlacedLight {
  public:
    MediumLight(const LightPlacement& placement, EmittingVolume volume, const FieldJobs& jobs);

    std::string_view kind() const override { return "medium"; }
    float power() const override { return power_; }
    bool sample_emission(const PrimaryPoint& u, EmissionSample& sample) const override;
    bool sample_direct(const Vec3& p, const Vec3& n, const Vec2& u,
                       DirectSample& sample) const override;
    float pdf_direct(const Vec3& p, const Vec3& n, const Vec3& wi, const Vec3& light_p,
                     const Vec3& light_n, std::uint32_t primitive) const override;

  private:
    /// A point of the volume, drawn by two numbers.
    struct Point {
        Vec3 position{0.0f};
        float pdf = 0;     ///< per volume
        float next = 0.5;  ///< one more number in [0, 1)
    };
    Point sample_point(const Vec2& u) const;
    /// Density per volume of sample_point() in a cell.
    float density(std::size_t cell) const;
    float line_pdf(const Vec3& p, const Vec3& wi) const;

    EmittingVolume volume_;
    RegularGrid grid_;
    CellChoice cells_;  ///< rows are those of the grid along x
    float cell_volume_ = 0;
    float power_ = 0;
};

}  // namespace lxs
