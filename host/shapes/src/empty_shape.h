// Shapes without extent.
#pragma once

#include "lxs/scene/registry.h"

namespace lxs {

/// Throws EmptyShape at the parameter `name`, or at the statement if it isn't given.
[[noreturn]] inline void fail_empty(const ParameterReader& reader, std::string_view name,
                                    const std::string& message) {
    throw EmptyShape(reader.where(name), message);
}

}  // namespace lxs
