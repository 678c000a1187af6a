// Shapes and transforms that several tests of the host build their scenes from.
#pragma once

#include "lxs/scene/contents.h"

namespace lxs::test {

/// Two triangles: corner, corner + u, corner + u + v, corner + v; normal along u x v.
TriangleMesh parallelogram(const Vec3& corner, const Vec3& u, const Vec3& v);

Matrix translation(double x, double y, double z);
Matrix scaling(double x, double y, double z);

}  // namespace lxs::test
