// Transforms that change in time (MotionBegin/End).
#pragma once

#include <ImathQuat.h>

#include <vector>

#include "lxs/sdk/types.h"

namespace lxs {

/// Where something stands at a time, in the unit of the camera's shutter.
struct MotionKey {
    double time = 0;
    Matrix matrix;
};

/// Keys of ascending times; empty for what stands still.
using Motion = std::vector<MotionKey>;

/// Interpolates a motion: between two keys translation and stretch go linearly and rotation turns
/// at a constant rate (Shoemake and Duff 1992, "Matrix animation and polar decomposition"); before
/// the first and after the last key it stays.
class MotionPath {
  public:
    /// `motion` is not empty; its matrices are affine and invertible.
    explicit MotionPath(const Motion& motion);
    Matrix at(double time) const;
    /// Transforms at equal steps from `begin` to `end` between which straight interpolation of the
    /// matrices keeps within about a thousandth of the turned distances; two to 129.
    std::vector<Matrix> steps(double begin, double end) const;

  private:
    /// A key as stretch (which may mirror), then rotation, then translation.
    struct Key {
        double time;
        Imath::M33d stretch;
        Imath::Quatd rotation;  ///< the nearer of both signs to the key before
        Imath::V3d translation;
    };
    std::vector<Key> keys_;
};

/// A transform that may move; `matrix` is where it stands first.
struct MovingTransform {
    Matrix matrix;
    Motion motion;

    /// At `time`.
    Matrix at(double time) const;
};

/// First `inner`, then `outer`; moves if either does, with the keys of both.
MovingTransform combined(const MovingTransform& inner, const MovingTransform& outer);

}  // namespace lxs
