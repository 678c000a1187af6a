// Parameters that analytic shapes share: declarations and checks.
#pragma once

#include "mesh_data.h"

namespace lxs {

inline constexpr double kLargestLength = kLargestCoordinate;

ParameterDeclaration length_parameter(std::string_view name, std::string_view default_text,
                                      std::string_view doc, double minimum);
ParameterDeclaration sweep_parameter();  ///< phimax
ParameterDeclaration name_parameter();

/// The number, declared as a length or sweep; EmptyShape if it is 0.
float positive(const ParameterReader& reader, std::string_view name, double fallback);
/// The number; InputError if it is not finite.
float finite(const ParameterReader& reader, std::string_view name, double fallback);
/// phimax, at most 360 degrees.
float sweep_angle(const ParameterReader& reader);

/// Throws InputError unless the transform is affine and invertible.
void check_transform(const Matrix& to_world, const ParameterReader& reader);

}  // namespace lxs
