// Interpolation of transforms.
#include "lxs/scene/motion.h"

#include <ImathMatrixAlgo.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lxs {
namespace {

using Imath::M33d;
using Imath::Quatd;
using Imath::V3d;

M33d transposed_inverse(const M33d& m) {
    return m.inverse().transposed();
}

double norm(const M33d& m) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k)
            sum += m[i][k] * m[i][k];
    }
    return std::sqrt(sum);
}

Quatd to_quaternion(const M33d& r) {
    // Imath's extractQuat takes matrices that act on row vectors, as all here.
    const Imath::M44d m(r[0][0], r[0][1], r[0][2], 0, r[1][0], r[1][1], r[1][2], 0, r[2][0],
                        r[2][1], r[2][2], 0, 0, 0, 0, 1);
    return Imath::extractQuat(m).normalized();
}

M33d linear_part(const Matrix& matrix) {
    M33d linear;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k)
            linear[i][k] = matrix[i][k];
    }
    return linear;
}

/// The rotation nearest to a matrix: Higham's iteration for the polar decomposition (1986).
M33d nearest_rotation(const M33d& linear) {
    M33d rotation = linear * (std::sqrt(3.0) / norm(linear));
    constexpr int kMostSteps = 100;
    for (int i = 0; i < kMostSteps; ++i) {
        const M33d next = (rotation + transposed_inverse(rotation)) * 0.5;
        const double change = norm(next - rotation);
        rotation = next;
        if (change < 1e-14) break;
    }
    return rotation.determinant() < 0 ? rotation * -1.0 : rotation;
}

Matrix composed(const M33d& stretch, const Quatd& rotation, const V3d& translation) {
    const M33d linear = stretch * rotation.toMatrix33();
    Matrix result;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k)
            result[i][k] = linear[i][k];
        result[3][i] = translation[i];
    }
    return result;
}

}  // namespace

MotionPath::MotionPath(const Motion& motion) {
    for (const MotionKey& key : motion) {
        const M33d linear = linear_part(key.matrix);
        const M33d rotation = nearest_rotation(linear);
        Quatd turn = to_quaternion(rotation);
        if (!keys_.empty() && (turn ^ keys_.back().rotation) < 0) turn = Quatd(-turn.r, -turn.v);
        keys_.push_back({key.time, linear * rotation.transposed(), turn,
                         V3d(key.matrix[3][0], key.matrix[3][1], key.matrix[3][2])});
    }
}

Matrix MotionPath::at(double time) const {
    const auto after =
        std::find_if(keys_.begin(), keys_.end(), [&](const Key& key) { return key.time > time; });
    const Key& b = after == keys_.end() ? keys_.back() : *after;
    const Key& a = after == keys_.begin() ? b : *(after - 1);
    const double share = b.time > a.time ? std::min(1.0, (time - a.time) / (b.time - a.time)) : 0;
    return composed(a.stretch * (1 - share) + b.stretch * share,
                    Imath::slerp(a.rotation, b.rotation, share),
                    a.translation * (1 - share) + b.translation * share);
}

std::vector<Matrix> MotionPath::steps(double begin, double end) const {
    // Chords of an arc of angle a leave it by 1 - cos(a / 2) of the radius.
    constexpr double kTurn = 5 * std::numbers::pi / 180;
    constexpr double kMostSteps = 128;  // the kernel takes 129 transforms
    constexpr double kStepsOfCorners = 64;
    double count = 1;
    for (std::size_t i = 0; i + 1 < keys_.size(); ++i) {
        const Key &a = keys_[i], &b = keys_[i + 1];
        const double turn = 2 * std::acos(std::min(1.0, std::abs(a.rotation ^ b.rotation)));
        // Steps are equal: the fastest turn sets them for the whole interval.
        count = std::max(count, std::ceil(turn / kTurn) * (end - begin) / (b.time - a.time));
    }
    for (const Key& key : keys_) {
        if (key.time > begin && key.time < end) count = std::max(count, kStepsOfCorners);
    }
    count = std::min(std::ceil(count), kMostSteps);
    std::vector<Matrix> result;
    for (double i = 0; i <= count; ++i)
        result.push_back(at(begin + (end - begin) * (i / count)));
    return result;
}

Matrix MovingTransform::at(double time) const {
    return motion.empty() ? matrix : MotionPath(motion).at(time);
}

MovingTransform combined(const MovingTransform& inner, const MovingTransform& outer) {
    MovingTransform result;
    std::vector<double> times;
    for (const Motion* motion : {&inner.motion, &outer.motion}) {
        for (const MotionKey& key : *motion)
            times.push_back(key.time);
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    for (const double time : times)
        result.motion.push_back({time, inner.at(time) * outer.at(time)});
    result.matrix = times.empty() ? inner.matrix * outer.matrix : result.motion.front().matrix;
    return result;
}

}  // namespace lxs
