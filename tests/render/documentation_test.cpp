// Protects parameters.md and scene-language.md of docs/reference: they are what the declarations
// say. To renew them: scripts/parameter-page > docs/reference/parameters.md,
// scripts/scene-language-page > docs/reference/scene-language.md
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "rendered_image.h"

namespace documentation_test {
namespace {

TEST(Documentation, ParameterPageMatchesTheDeclarations) {
    std::ifstream in(std::string(DOCS) + "/reference/parameters.md");
    std::stringstream page;
    page << in.rdbuf();
    for (const std::string plugin : {"aips", "sppm", "ppm", "exphotonmap", "path"}) {
        const std::string table =
            render::output_of(std::string(LXSRENDER) + " --describe " + plugin + " --markdown");
        ASSERT_FALSE(table.empty());
        EXPECT_NE(page.str().find(table), std::string::npos)
            << "docs/reference/parameters.md does not hold the present table of " << plugin;
    }
}

TEST(Documentation, SceneLanguagePageMatchesTheDeclarations) {
    std::ifstream in(std::string(DOCS) + "/reference/scene-language.md");
    std::stringstream page;
    page << in.rdbuf();
    const std::string tables = render::output_of(std::string(LXSRENDER) + " --scene-language");
    ASSERT_GT(tables.size(), 10000u);
    EXPECT_NE(page.str().find(tables), std::string::npos)
        << "docs/reference/scene-language.md does not hold the present tables";
}

}  // namespace
}  // namespace documentation_test
