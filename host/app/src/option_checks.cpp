// Checks of command line values that the project's programs share.
#include "lxs/host/option_checks.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

namespace lxs {
namespace {

template <class Fits>
std::string check_number(const std::string& text, const Fits& fits, std::string_view wanted) {
    double value = 0;
    const bool read = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
    return read && fits(value) ? "" : fmt::format("expected {}, found \"{}\"", wanted, text);
}

}  // namespace

std::string check_override(const std::string& text) {
    const auto dot = text.find('.');
    const auto equals = text.find('=');
    const bool whole =
        dot != std::string::npos && equals != std::string::npos && dot > 0 && dot + 1 < equals;
    return whole ? "" : "expected plugin.parameter=value, found \"" + text + "\"";
}

std::string check_positive(const std::string& text) {
    return check_number(
        text, [](double value) { return value > 0; }, "a number above 0");
}

std::string check_not_negative(const std::string& text) {
    return check_number(
        text, [](double value) { return value >= 0; }, "a number of at least 0");
}

std::string check_within(const std::string& text, double most) {
    return check_number(
        text, [&](double value) { return std::abs(value) <= most; },
        fmt::format("a number from -{0} to {0}", most));
}

}  // namespace lxs
