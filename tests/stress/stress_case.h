// What all stress tests share: their short and long forms, and the rows of the table that
// scripts/stress prints.
#pragma once

#include <string_view>

namespace stress {

/// Whether the long form was asked for (environment variable AIPS_STRESS is "long"), as
/// scripts/stress does. The short form is part of every test run: seconds per case.
bool long_form();

/// The size of a case in the form that is being run.
template <class Number>
Number sized(Number in_short_form, Number in_long_form) {
    return long_form() ? in_long_form : in_short_form;
}

/// The running test's row of the table: what was tried ("1e9 terms of 1e-3 to 1e3"), and the figure
/// that came out beside the bound that it must keep ("relative error 3e-8 of at most 1e-6").
void record(std::string_view tried, std::string_view figure);

}  // namespace stress
