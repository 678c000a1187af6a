// Checks of command line values that the project's programs share. Each returns "" or what is
// wrong, as CLI11's validators do.
#pragma once

#include <string>

namespace lxs {

/// plugin.parameter=value
std::string check_override(const std::string& text);

/// A finite number above 0.
std::string check_positive(const std::string& text);

/// A finite number, 0 or above.
std::string check_not_negative(const std::string& text);

/// A number from -most to most.
std::string check_within(const std::string& text, double most);

}  // namespace lxs
