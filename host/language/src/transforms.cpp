// Matrices of the transform statements.
#include "lxs/language/transforms.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace lxs {
namespace {

using Vector = Imath::V3d;

Vector vector_of(std::span<const double, 3> v) {
    return {v[0], v[1], v[2]};
}

Vector row(const Matrix& m, int i) {
    return {m[i][0], m[i][1], m[i][2]};
}

}  // namespace

Matrix translation(std::span<const double, 3> offset) {
    Matrix m;
    m.setTranslation(vector_of(offset));
    return m;
}

Matrix scaling(std::span<const double, 3> factors) {
    Matrix m;
    m.setScale(vector_of(factors));
    return m;
}

Matrix rotation(double degrees, std::span<const double, 3> axis, const SourceLocation& where) {
    const Vector direction = vector_of(axis);
    if (direction.length() == 0) throw InputError(where, "Rotate about an axis of length 0");
    Matrix m;
    // Whole turns first: the sine of a huge angle in radians would have lost all digits.
    m.setAxisAngle(direction, std::fmod(degrees, 360.0) * std::numbers::pi / 180);
    return m;
}

Matrix look_at(std::span<const double, 9> eye_target_up, const SourceLocation& where) {
    const Vector eye = vector_of(eye_target_up.subspan<0, 3>());
    const Vector direction = (vector_of(eye_target_up.subspan<3, 3>()) - eye).normalized();
    const Vector up = vector_of(eye_target_up.subspan<6, 3>()).normalized();
    if (direction.length() == 0) throw InputError(where, "LookAt: eye and target are one point");
    if (up.length() == 0) throw InputError(where, "LookAt: the up vector has length 0");
    const Vector across = direction.cross(up);
    constexpr double kParallel = 1e-9;  // sine of the angle between view and up
    if (across.length() < kParallel) {
        throw InputError(where, "LookAt: the up vector is parallel to the view direction");
    }
    const Vector right = across.normalized();
    const Vector camera_up = right.cross(direction);
    // The inverse of a rotation is its transpose: columns hold the camera's axes.
    return {right.x,         camera_up.x,         direction.x,         0,
            right.y,         camera_up.y,         direction.y,         0,
            right.z,         camera_up.z,         direction.z,         0,
            -right.dot(eye), -camera_up.dot(eye), -direction.dot(eye), 1};
}

Matrix listed_matrix(std::span<const double, 16> values, const SourceLocation& where) {
    Matrix m;
    const double scale = values[15];
    constexpr double kRounding = 1e-6;  // exporters' noise in what should be 0
    if (scale == 0) throw InputError(where, "the matrix maps space to infinity (last number 0)");
    double* const cells = m.getValue();
    for (std::size_t i = 0; i < 16; ++i)
        cells[i] = values[i] / scale;
    for (int i = 0; i < 3; ++i) {
        if (std::abs(m[i][3]) > kRounding) {
            throw InputError(where,
                             "the matrix is projective (numbers 4, 8 and 12 must be 0); "
                             "translation stands in numbers 13 to 15");
        }
        m[i][3] = 0;
    }
    return m;
}

void check_invertible(const Matrix& matrix, const SourceLocation& where) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    double edges = 1;
    for (int i = 0; i < 4; ++i) {
        const double length = row(matrix, i).length();
        // Written so that NaN fails too.
        if (!(length <= kLargest)) {
            throw InputError(where, "the transform's numbers grow beyond 3.4e38");
        }
        if (i < 3) edges *= length;
    }
    // Volume of the image of the unit cube over that of a box with the same edges: no scale in it.
    constexpr double kFlat = 1e-12;
    const double volume = row(matrix, 0).dot(row(matrix, 1).cross(row(matrix, 2)));
    if (!(std::abs(volume) > kFlat * edges)) {
        throw InputError(where, "the transform is singular: it flattens space");
    }
}

}  // namespace lxs
