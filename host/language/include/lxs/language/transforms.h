// Matrices of the transform statements, in Imath's row-vector order (translation in row 3).
#pragma once

#include <span>

#include "lxs/sdk/diagnostics.h"
#include "lxs/sdk/types.h"

namespace lxs {

Matrix translation(std::span<const double, 3> offset);
Matrix scaling(std::span<const double, 3> factors);

/// Counter-clockwise by `degrees` about `axis`. Throws InputError for an axis of length 0.
Matrix rotation(double degrees, std::span<const double, 3> axis, const SourceLocation& where);

/// World to camera: the camera at `eye` looks along +z at `target`, x to the right, y up. Throws
/// InputError if they leave the view or its up direction open.
Matrix look_at(std::span<const double, 9> eye_target_up, const SourceLocation& where);

/// A listed matrix. Throws InputError if it is projective.
Matrix listed_matrix(std::span<const double, 16> values, const SourceLocation& where);

/// Throws InputError if `matrix` flattens space or has grown beyond single precision.
void check_invertible(const Matrix& matrix, const SourceLocation& where);

}  // namespace lxs
