// Protects docs/errors.md: it lists every exit code with the meaning that --help gives.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "lxs/host/exit_code.h"

namespace lxs::test {
namespace {

TEST(ErrorsPage, ListsEveryExitCode) {
    std::ifstream file(ERRORS_PAGE);
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    for (const auto& [code, meaning] : kExitCodes) {
        const std::string row = fmt::format("| {} | {} |", static_cast<int>(code), meaning);
        EXPECT_THAT(page, testing::HasSubstr(row));
    }
}

}  // namespace
}  // namespace lxs::test
