// An affine map in double precision, with its inverse.
#pragma once

#include "lxs/sdk/types.h"

namespace lxs {

class AffineMap {
  public:
    /// `matrix` is affine and invertible.
    explicit AffineMap(const Matrix& matrix) {
        const Matrix inverse = matrix.inverse();
        for (int i = 0; i < 3; ++i) {
            axes_[i] = Imath::V3d(matrix[i][0], matrix[i][1], matrix[i][2]);
            duals_[i] = Imath::V3d(inverse[0][i], inverse[1][i], inverse[2][i]);
        }
        translation_ = Imath::V3d(matrix[3][0], matrix[3][1], matrix[3][2]);
    }

    Imath::V3d point(const Imath::V3d& p) const { return translation_ + vector(p); }
    Imath::V3d vector(const Imath::V3d& v) const {
        return axes_[0] * v.x + axes_[1] * v.y + axes_[2] * v.z;
    }
    /// Image of a normal (by the inverse transpose), not of unit length.
    Imath::V3d normal(const Imath::V3d& n) const {
        return duals_[0] * n.x + duals_[1] * n.y + duals_[2] * n.z;
    }
    Imath::V3d inverse_point(const Imath::V3d& p) const { return inverse_vector(p - translation_); }
    Imath::V3d inverse_vector(const Imath::V3d& v) const {
        return {duals_[0].dot(v), duals_[1].dot(v), duals_[2].dot(v)};
    }

    /// Image of the i-th axis.
    const Imath::V3d& axis(int i) const { return axes_[i]; }
    /// The i-th coordinate of inverse_vector(v) is the scalar product of v and this.
    const Imath::V3d& dual(int i) const { return duals_[i]; }
    const Imath::V3d& translation() const { return translation_; }
    bool mirrors() const { return axes_[0].dot(axes_[1].cross(axes_[2])) < 0; }

  private:
    Imath::V3d axes_[3];
    Imath::V3d duals_[3];
    Imath::V3d translation_;
};

}  // namespace lxs
