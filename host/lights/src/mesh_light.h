// Area light of a triangle mesh: triangles chosen by area.
#pragma once

#include <vector>

#include "surface_light.h"

namespace lxs {

class MeshLight final : public SurfaceLight {
  public:
    MeshLight(const Primitive& primitive, const AreaEmission& emission, const TriangleMesh& mesh,
              const Matrix& to_world);

  private:
    struct Triangle {
        Vec3 p, e1, e2;           ///< first vertex and edges to the others
        Vec3 n;                   ///< unit, emitting side
        Vec3 error;               ///< bound of the rounding error of any point, per coordinate
        std::uint32_t primitive;  ///< index in the mesh, which may have triangles of zero area
    };
    struct TriangleUvs {
        Vec2 a, b, c;
    };

    SurfacePoint sample_surface(const Vec2& u) const override;
    bool surface_coordinates(const Vec3& p, std::uint32_t primitive, Vec2& u) const override;
    float area_density(const Vec3& /*p*/) const override { return density_; }

    std::vector<Triangle> triangles_;  ///< those of non-zero area, in the mesh's order
    std::vector<TriangleUvs> uvs_;     ///< parallel to triangles_, or empty
    std::vector<float> cdf_;           ///< of area, at the upper end of each triangle; last is 1
    float density_ = 0;
};

}  // namespace lxs
