// Short and long form of the stress tests, and their rows.
#include "stress_case.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace stress {

bool long_form() {
    const char* form = std::getenv("AIPS_STRESS");
    return form && std::string_view(form) == "long";
}

void record(std::string_view tried, std::string_view figure) {
    testing::Test::RecordProperty("tried", std::string(tried));
    testing::Test::RecordProperty("figure", std::string(figure));
}

}  // namespace stress
