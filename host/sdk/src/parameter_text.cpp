// Words for declared parameters in help and error messages.
#include "parameter_text.h"

#include <charconv>
#include <cmath>

namespace lxs {
namespace {
using Type = ParameterType;
}

std::string number_text(double value) {
    char buffer[32];
    const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
    return {buffer, result.ptr};
}

std::string written_form(const ParameterDeclaration& declaration) {
    const std::string name(declaration.name);
    const std::string texture = " or \"texture " + name + "\" [\"name\"]";
    switch (declaration.type) {
        case Type::Float:
            return "\"float " + name + "\" [number]";
        case Type::Integer:
            return "\"integer " + name + "\" [number]";
        case Type::Bool:
            return "\"bool " + name + "\" [\"true\" or \"false\"]";
        case Type::String:
            return "\"string " + name + "\" [\"text\"]";
        case Type::Color:
            return "\"color " + name + "\" [r g b]";
        case Type::Point:
        case Type::Vector:
        case Type::Normal:
            return in_quotes(std::string(type_name(declaration.type)) + " " + name) + " [x y z]";
        case Type::FloatTexture:
            return "\"float " + name + "\" [number]" + texture;
        case Type::ColorTexture:
            return "\"color " + name + "\" [r g b]" + texture;
        case Type::FresnelTexture:
            return "\"float " + name + "\" [index]" + texture;
    }
    return {};
}

std::string_view type_name(ParameterType type) {
    switch (type) {
        case Type::Float:
            return "float";
        case Type::Integer:
            return "integer";
        case Type::Bool:
            return "bool";
        case Type::String:
            return "string";
        case Type::Color:
            return "color";
        case Type::Point:
            return "point";
        case Type::Vector:
            return "vector";
        case Type::Normal:
            return "normal";
        case Type::FloatTexture:
            return "float texture";
        case Type::ColorTexture:
            return "color texture";
        case Type::FresnelTexture:
            return "fresnel texture";
    }
    return {};
}

std::string range_text(const ParameterDeclaration& declaration) {
    const bool low = std::isfinite(declaration.minimum);
    const bool high = std::isfinite(declaration.maximum);
    if (low && high) {
        return "between " + number_text(declaration.minimum) + " and " +
               number_text(declaration.maximum);
    }
    if (low) return "at least " + number_text(declaration.minimum);
    if (high) return "at most " + number_text(declaration.maximum);
    return {};
}

}  // namespace lxs
