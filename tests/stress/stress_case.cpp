// Rows of the stress tests.
#include "stress_case.h"

#include <gtest/gtest.h>

#include <string>

namespace stress {

void record(std::string_view tried, std::string_view figure) {
    testing::Test::RecordProperty("tried", std::string(tried));
    testing::Test::RecordProperty("figure", std::string(figure));
}

}  // namespace stress
