// Orientation of a light at infinity.
#pragma once

#include "lxs/sdk/diagnostics.h"
#include "lxs/sdk/types.h"

namespace lxs {

/// Rotation, possibly with a mirroring, that a transform applies to directions.
class Rotation {
  public:
    /// Scale and shear of `to_world` are left out (Gram-Schmidt), as they would distort solid
    /// angles; throws InputError at `where` if the transform is singular.
    Rotation(const Matrix& to_world, const SourceLocation& where) {
        Imath::V3d axes[3];
        for (int i = 0; i < 3; ++i) {
            axes[i] = Imath::V3d(to_world[i][0], to_world[i][1], to_world[i][2]).normalized();
            for (int j = 0; j < i; ++j)
                axes[i] -= axes[j] * (axes[i] ^ axes[j]);
            constexpr double kSingular = 1e-9;
            if (!(axes[i].length() > kSingular))
                throw InputError(where, "the light's transform is singular");
            axes[i].normalize();
        }
        x_ = Vec3(axes[0]), y_ = Vec3(axes[1]), z_ = Vec3(axes[2]);
    }
    Vec3 to_world(const Vec3& v) const { return x_ * v.x + y_ * v.y + z_ * v.z; }
    Vec3 to_local(const Vec3& v) const { return Vec3(x_ ^ v, y_ ^ v, z_ ^ v); }

  private:
    Vec3 x_, y_, z_;
};

}  // namespace lxs
