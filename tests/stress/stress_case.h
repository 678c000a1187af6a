// What all stress tests share: their short and long forms, and the rows of the table that
// scripts/stress prints.
#pragma once

#include <string_view>

#include "test_form.h"

namespace stress {

using statistics::long_form;
using statistics::sized;

/// The running test's row of the table: what was tried ("1e9 terms of 1e-3 to 1e3"), and the figure
/// that came out beside the bound that it must keep ("relative error 3e-8 of at most 1e-6").
void record(std::string_view tried, std::string_view figure);

}  // namespace stress
