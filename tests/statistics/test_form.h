// The short and the long form of tests whose cost is their number of renders.
#pragma once

#include <cstdlib>
#include <string_view>

namespace statistics {

/// Whether the long form was asked for (environment variable AIPS_TEST_FORM is "long"), as
/// `scripts/test --thorough` and scripts/stress do. The short form is what every test run has.
inline bool long_form() {
    const char* form = std::getenv("AIPS_TEST_FORM");
    return form && std::string_view(form) == "long";
}

/// The size of a case, or what it must find, in the form that is being run.
template <class Number>
Number sized(Number in_short_form, Number in_long_form) {
    return long_form() ? in_long_form : in_short_form;
}

}  // namespace statistics
