// Checks of command line values that the project's programs share.
#include "lxs/host/option_checks.h"

#include <CLI/CLI.hpp>
#include <cmath>

namespace lxs {

std::string check_override(const std::string& text) {
    const auto dot = text.find('.');
    const auto equals = text.find('=');
    const bool whole =
        dot != std::string::npos && equals != std::string::npos && dot > 0 && dot + 1 < equals;
    return whole ? "" : "expected plugin.parameter=value, found \"" + text + "\"";
}

std::string check_positive(const std::string& text) {
    double value = 0;
    const bool read = CLI::detail::lexical_cast(text, value);
    return read && value > 0 && std::isfinite(value)
               ? ""
               : "expected a number above 0, found \"" + text + "\"";
}

std::string check_not_negative(const std::string& text) {
    double value = 0;
    const bool read = CLI::detail::lexical_cast(text, value);
    return read && value >= 0 && std::isfinite(value)
               ? ""
               : "expected a number of at least 0, found \"" + text + "\"";
}

}  // namespace lxs
