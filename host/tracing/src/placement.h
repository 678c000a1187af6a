// Where the surfaces of an instance stand in the world, with rounding bounds.
#pragma once

#include <vector>

#include "affine_map.h"

namespace lxs {

/// Transform of an instance and the error that the kernel makes with it.
class InstanceTransform {
  public:
    /// `kernel_error`: how many times as large the kernel's error is as with a still transform.
    explicit InstanceTransform(const Matrix& to_world, double kernel_error = 1);
    const AffineMap& map() const { return map_; }
    /// Bound, per world coordinate, of how far the kernel's single-precision transform displaces a
    /// ray that starts at `p`.
    Vec3 tracing_error(const Vec3& p) const;

  private:
    AffineMap map_;
    Vec3 error_rows_[3];  ///< error = rows * (|p| + |translation|)
    Vec3 translation_;    ///< absolute values
};

/// Transforms of a moving instance at equal steps of `begin`..`end`, straight between them, as the
/// kernel sees them.
class MovingPlacement {
  public:
    MovingPlacement(std::vector<Matrix> steps, double begin, double end)
        : steps_(std::move(steps)), begin_(begin), end_(end) {}
    const std::vector<Matrix>& steps() const { return steps_; }
    InstanceTransform at(float time) const;

  private:
    std::vector<Matrix> steps_;
    double begin_, end_;
};

}  // namespace lxs
