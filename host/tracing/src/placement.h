// Where the surfaces of an instance stand in the world, with rounding bounds.
#pragma once

#include "affine_map.h"

namespace lxs {

/// Transform of an instance and the error that the kernel makes with it.
class InstanceTransform {
  public:
    explicit InstanceTransform(const Matrix& to_world);
    const AffineMap& map() const { return map_; }
    /// Bound, per world coordinate, of how far the kernel's single-precision transform displaces a
    /// ray that starts at `p`.
    Vec3 tracing_error(const Vec3& p) const;

  private:
    AffineMap map_;
    Vec3 error_rows_[3];  ///< error = rows * (|p| + |translation|)
    Vec3 translation_;    ///< absolute values
};

}  // namespace lxs
