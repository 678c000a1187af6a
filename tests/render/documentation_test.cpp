// Protects docs/parameters.md: it is what the declarations say.
// To renew it: scripts/parameter-page > docs/parameters.md
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "rendered_image.h"

namespace {

TEST(Documentation, ParameterPageMatchesTheDeclarations) {
    std::ifstream in(std::string(DOCS) + "/parameters.md");
    std::stringstream page;
    page << in.rdbuf();
    for (const std::string plugin : {"aips", "sppm", "ppm", "exphotonmap"}) {
        const std::string table =
            render::output_of(std::string(LXSRENDER) + " --describe " + plugin + " --markdown");
        ASSERT_FALSE(table.empty());
        EXPECT_NE(page.str().find(table), std::string::npos)
            << "docs/parameters.md does not hold the present table of " << plugin;
    }
}

}  // namespace
