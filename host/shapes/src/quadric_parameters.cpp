// Parameters that analytic shapes share: declarations and checks.
#include "quadric_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "empty_shape.h"

namespace lxs {

ParameterDeclaration length_parameter(std::string_view name, std::string_view default_text,
                                      std::string_view doc, double minimum) {
    return {name, ParameterType::Float, default_text, doc, minimum, kLargestLength};
}

ParameterDeclaration sweep_parameter() {
    return {"phimax", ParameterType::Float, "360", "Angle around the z axis, degrees.", 0, 360};
}

ParameterDeclaration name_parameter() {
    return {"name", ParameterType::String, "", "Name of the shape in messages."};
}

float positive(const ParameterReader& reader, std::string_view name, double fallback) {
    const auto value = static_cast<float>(reader.number(name, fallback));
    if (!(value > 0)) {
        fail_empty(reader, name,
                   fmt::format("\"{}\" is {}: expected a number above 0", name, value));
    }
    return value;
}

float finite(const ParameterReader& reader, std::string_view name, double fallback) {
    const auto value = static_cast<float>(reader.number(name, fallback));
    if (!(std::abs(value) <= kLargestCoordinate))
        reader.fail(name, fmt::format("\"{}\" is not finite: {}", name, value));
    return value;
}

float sweep_angle(const ParameterReader& reader) {
    return std::min(positive(reader, "phimax", 360), 360.0f);
}

void check_transform(const Matrix& to_world, const ParameterReader& reader) {
    bool affine =
        to_world[0][3] == 0 && to_world[1][3] == 0 && to_world[2][3] == 0 && to_world[3][3] == 1;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 3; ++column)
            affine &= std::abs(to_world[row][column]) <= kLargestLength;
    }
    const double determinant = to_world.determinant();
    if (affine && std::isfinite(determinant) && determinant != 0) return;
    throw InputError(reader.where(),
                     fmt::format("the current transform can't be inverted or is not affine: a {} "
                                 "can't be placed with it",
                                 reader.plugin()));
}

}  // namespace lxs
