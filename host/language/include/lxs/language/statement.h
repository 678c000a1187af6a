// One statement of a scene file as the parser leaves it: a word and its arguments, not interpreted.
#pragma once

#include <string>
#include <vector>

#include "lxs/sdk/parameters.h"

namespace lxs {

/// A string, a list in brackets, or a run of numbers without brackets.
struct Argument {
    SourceLocation where;                     ///< of its first character
    decltype(ParameterValue::values) values;  ///< an empty list holds no numbers
    std::vector<SourceLocation> value_where;  ///< of the first values only
    bool bracketed = false;
};

struct Statement {
    std::string name;
    SourceLocation where;
    std::vector<Argument> arguments;
};

}  // namespace lxs
