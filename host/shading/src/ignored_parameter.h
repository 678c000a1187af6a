// Parameters that are accepted for compatibility only.
#pragma once

#include "lxs/sdk/parameters.h"

namespace lxs::shading {

/// A declaration with ParameterDeclaration::no_effect.
inline ParameterDeclaration ignored(std::string_view name, ParameterType type,
                                    std::string_view default_text, std::string_view doc) {
    ParameterDeclaration declaration{name, type, default_text, doc};
    declaration.no_effect = true;
    return declaration;
}

}  // namespace lxs::shading
