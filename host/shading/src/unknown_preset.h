// Names of presets that there are none of.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "lxs/sdk/parameters.h"

namespace lxs::shading {

/// Says that the string parameter `parameter` names none of `known`, presets of a `kind` in words,
/// and that the preset `used` stands in, as it does in LuxRender.
template <class Presets>
void warn_of_unknown_preset(const ParameterReader& reader, std::string_view parameter,
                            std::string_view kind, const Presets& known, std::string_view used) {
    std::vector<std::string> names;
    names.reserve(known.size());
    for (const auto& preset : known)
        names.emplace_back(preset.name);
    reader.diagnostics().fallback(reader.where(parameter),
                                  unknown_name_message(kind, reader.string(parameter, ""), names),
                                  fmt::format("\"{}\" is used instead", used));
}

}  // namespace lxs::shading
