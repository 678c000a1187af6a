// What is used in place of a parameter's value that does not fit its declaration.
#pragma once

#include <optional>
#include <string>

#include "lxs/sdk/parameters.h"

namespace lxs {

struct MendedParameter {
    std::optional<ParameterValue> value;  ///< none: the parameter counts as not given
    std::string instead;                  ///< in words, for a message: "0 is used"
};

/// As LuxRender does where it goes on: fractions of whole numbers are dropped, as are numbers
/// behind the last whole colour or point, a bool that is neither true nor false is false, and what
/// else is wrong counts as not given. Numbers out of range become the nearest in it, where
/// LuxRender takes them as they are.
MendedParameter mend_parameter(const ParameterValue& value,
                               const ParameterDeclaration& declaration);

}  // namespace lxs
