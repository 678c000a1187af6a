// Chooses the area light class for an emissive shape.
#include <cmath>

#include "lxs/lights/lights.h"
#include "mesh_light.h"
#include "quadric_light.h"
#include "revolution_light.h"
#include "sphere_light.h"

namespace lxs {
namespace {

bool is_similarity(const Matrix& m) {
    const auto row = [&](int i) { return Imath::V3d(m[i][0], m[i][1], m[i][2]); };
    const double scale2 = row(0).length2();
    constexpr double kTolerance = 1e-6;
    for (int i = 0; i < 3; ++i) {
        if (!(std::abs(row(i).length2() - scale2) <= kTolerance * scale2)) return false;
        if (!(std::abs(row(i) ^ row((i + 1) % 3)) <= kTolerance * scale2)) return false;
    }
    return scale2 > 0;
}

bool is_whole(const Sphere& s) {
    return s.phi_max >= 360 && std::min(s.z_min, s.z_max) <= -s.radius &&
           std::max(s.z_min, s.z_max) >= s.radius;
}

}  // namespace

std::unique_ptr<AreaLight> make_area_light(const Primitive& primitive,
                                           const Matrix& instance_to_world) {
    const AreaEmission& emission = primitive.emission.value();
    if (const TriangleMesh* mesh = std::get_if<TriangleMesh>(&primitive.geometry))
        return std::make_unique<MeshLight>(primitive, emission, *mesh, instance_to_world);
    const Quadric& quadric = std::get<Quadric>(primitive.geometry);
    if (const auto shape = SurfaceOfRevolution::of(quadric)) {
        return std::make_unique<RevolutionLight>(primitive, emission, quadric, *shape,
                                                 instance_to_world);
    }
    const bool inverted = primitive.reverse_orientation != (quadric.to_world.determinant() < 0);
    const Matrix to_world = quadric.to_world * instance_to_world;
    const Sphere* sphere = std::get_if<Sphere>(&quadric.shape);
    if (sphere && is_whole(*sphere) && sphere->radius > 0 && !inverted && is_similarity(to_world)) {
        Matrix unit;
        unit.setScale(double(sphere->radius));
        return std::make_unique<SphereLight>(primitive, emission, unit * to_world,
                                             instance_to_world);
    }
    const FlatOrRound patch =
        sphere ? FlatOrRound(*sphere) : FlatOrRound(std::get<Disk>(quadric.shape));
    return std::make_unique<QuadricLight>(primitive, emission, patch, quadric.to_world,
                                          instance_to_world);
}

}  // namespace lxs
