// Area light of a triangle mesh: triangles chosen by area.
#pragma once

#include <vector>

#include "cell_choice.h"
#include "surface_light.h"

namespace lxs {

class MeshLight final : public SurfaceLight {
  public:
    MeshLight(const Primitive& primitive, const AreaEmission& emission, const TriangleMesh& mesh,
              const Matrix& to_world);

  private:
    struct Triangle {
        Vec3 p, e1, e2;     ///< first vertex and edges to the others
        Vec3 n{0.0f};       ///< unit, emitting side; zero for triangles without area
        Vec3 error;         ///< bound of the rounding error of any point, per coordinate
        float density = 0;  ///< per unit of area, that of all triangles but for rounding
    };
    struct TriangleUvs {
        Vec2 a, b, c;
    };

    SurfacePoint sample_surface(const Vec2& u) const override;
    bool surface_coordinates(const Vec3& p, std::uint32_t primitive, Vec2& u) const override;
    float area_density(const Vec3& /*p*/, std::uint32_t primitive) const override {
        return primitive < triangles_.size() ? triangles_[primitive].density : 0.0f;
    }
    void choose_by(const std::vector<double>& areas, double area);

    std::vector<Triangle> triangles_;  ///< in the mesh's order
    std::vector<TriangleUvs> uvs_;     ///< parallel to triangles_, or empty
    CellChoice choice_;                ///< of triangles, row by row
};

}  // namespace lxs
