// Options that change nothing here.
#pragma once

#include <fmt/format.h>

#include "lxs/sdk/parameters.h"

namespace lxs {

/// Warns at the parameter `name` that it has no effect, and what is done whatever its value.
inline void warn_of_no_effect(const ParameterReader& reader, std::string_view name,
                              std::string_view instead) {
    reader.diagnostics().warning(reader.where(name),
                                 fmt::format("\"{}\" has no effect: {}", name, instead));
}

}  // namespace lxs
