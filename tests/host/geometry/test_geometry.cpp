// Shapes and transforms that several tests of the host build their scenes from.
#include "test_geometry.h"

namespace lxs::test {

TriangleMesh parallelogram(const Vec3& corner, const Vec3& u, const Vec3& v) {
    TriangleMesh mesh;
    mesh.positions = {corner, corner + u, corner + u + v, corner + v};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

Matrix translation(double x, double y, double z) {
    return Matrix().setTranslation(Imath::V3d(x, y, z));
}

Matrix scaling(double x, double y, double z) {
    return Matrix().setScale(Imath::V3d(x, y, z));
}

}  // namespace lxs::test
