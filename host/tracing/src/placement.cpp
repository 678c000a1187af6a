// Rounding bounds of instance transforms.
#include "placement.h"

#include <algorithm>
#include <cmath>

#include "kernel_rounding.h"

namespace lxs {
namespace {

using Imath::V3d;

struct Table3 {
    double at[3][3];
};

Table3 product(const Table3& a, const Table3& b) {
    Table3 c{};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            for (int k = 0; k < 3; ++k)
                c.at[i][j] += a.at[i][k] * b.at[k][j];
        }
    }
    return c;
}

}  // namespace

// With M the linear part, T the translation, u the unit roundoff, |.| taken entry by entry and
// B = |M| |M^-1|: the kernel maps a ray's origin O to M^-1 O - M^-1 T by three chained
// multiply-adds. Rounding them displaces the result by at most 4u |M^-1| |O| + 7u |M^-1| |T|; its
// inverse itself, adjugate over determinant, is off by at most 8u |M^-1| |M| |M^-1|. Brought back
// to the world by |M|, the sum is at most u (7 B + 8 B B) (|O| + |T|).
InstanceTransform::InstanceTransform(const Matrix& to_world, double kernel_error) : map_(to_world) {
    Table3 linear{}, inverse{};  // [row: result][column: argument]
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            linear.at[i][j] = std::abs(map_.axis(j)[i]);
            inverse.at[i][j] = std::abs(map_.dual(i)[j]);
        }
        translation_[i] = static_cast<float>(std::abs(map_.translation()[i]));
    }
    const Table3 b = product(linear, inverse);
    const Table3 bb = product(b, b);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            error_rows_[i][j] = static_cast<float>(kernel_error * kKernelRoundoff *
                                                   (7 * b.at[i][j] + 8 * bb.at[i][j]));
        }
    }
}

// The kernel interpolates rounded matrices in single precision and inverts the result: its entries
// are off by 3u more than those of a still one, which adds at most as much as B B counts already.
InstanceTransform MovingPlacement::at(float time) const {
    constexpr double kKernelError = 2;
    const auto last = static_cast<double>(steps_.size() - 1);
    const double position =
        std::clamp((static_cast<double>(time) - begin_) / (end_ - begin_), 0.0, 1.0) * last;
    const double step = std::min(std::floor(position), last - 1);
    const auto index = static_cast<std::size_t>(step);
    const double share = position - step;
    return InstanceTransform(steps_[index] * (1 - share) + steps_[index + 1] * share, kKernelError);
}

Vec3 InstanceTransform::tracing_error(const Vec3& p) const {
    const Vec3 reach(std::abs(p.x) + translation_.x, std::abs(p.y) + translation_.y,
                     std::abs(p.z) + translation_.z);
    return {error_rows_[0].dot(reach), error_rows_[1].dot(reach), error_rows_[2].dot(reach)};
}

}  // namespace lxs
