// Placement of two-dimensional textures on surfaces: parameters.
#include "uv_mapping.h"

#include <fmt/format.h>

#include <array>

#include "ignored_parameter.h"

namespace lxs::shading {
namespace {

constexpr std::array<std::string_view, 4> kMappings{"uv", "spherical", "cylindrical", "planar"};

}  // namespace

std::vector<ParameterDeclaration> uv_mapping_parameters() {
    ParameterDeclaration mapping{"mapping", ParameterType::String, "uv", "how (u, v) are found"};
    mapping.choices = kMappings;
    return {mapping,
            {"uscale", ParameterType::Float, "1", "repetitions along u"},
            {"vscale", ParameterType::Float, "1", "repetitions along v"},
            {"udelta", ParameterType::Float, "0", "shift along u"},
            {"vdelta", ParameterType::Float, "0", "shift along v"},
            ignored("v1", ParameterType::Vector, "1 0 0", "first axis of a planar mapping"),
            ignored("v2", ParameterType::Vector, "0 1 0", "second axis of a planar mapping")};
}

UvMapping read_uv_mapping(const ParameterReader& reader) {
    const std::string mapping = reader.string("mapping", "uv");
    if (mapping != "uv") {
        reader.diagnostics().warning(reader.where("mapping"),
                                     fmt::format("mapping \"{}\" is not rendered yet; the "
                                                 "surface's own (u, v) are used",
                                                 mapping));
    }
    const auto number = [&](std::string_view name, double fallback) {
        return static_cast<float>(reader.number(name, fallback));
    };
    return {{number("uscale", 1), number("vscale", 1)}, {number("udelta", 0), number("vdelta", 0)}};
}

}  // namespace lxs::shading
