// What lies outside of a texture's unit square or cube: parameter "wrap".
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "texture_parameters.h"

namespace lxs::shading {

enum class Wrap : std::uint8_t { Repeat, Black, White, Clamp };

/// In the order of Wrap.
inline constexpr std::array<std::string_view, 4> kWraps{"repeat", "black", "white", "clamp"};

inline ParameterDeclaration wrap_parameter(std::string_view doc) {
    return choice("wrap", "repeat", doc, kWraps);
}

inline Wrap read_wrap(const ParameterReader& reader) {
    const std::string name = reader.string("wrap", "repeat");
    for (std::size_t i = 0; i < kWraps.size(); ++i)
        if (name == kWraps[i]) return static_cast<Wrap>(i);
    return Wrap::Repeat;
}

}  // namespace lxs::shading
