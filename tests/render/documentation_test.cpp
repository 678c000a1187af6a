// Protects parameters.md and scene-language.md of docs/reference: they are what the scripts of
// these names make of the declarations. To renew them: scripts/parameter-page >
// docs/reference/parameters.md, scripts/scene-language-page > docs/reference/scene-language.md
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "rendered_image.h"

namespace documentation_test {
namespace {

void expect_page_of(const std::string& script, const std::string& page) {
    std::ifstream in(std::string(DOCS) + "/reference/" + page);
    std::stringstream text;
    text << in.rdbuf();
    const std::string made =
        render::output_of(std::string(DOCS) + "/../scripts/" + script + " " + LXSRENDER);
    ASSERT_GT(made.size(), 10000u);
    EXPECT_EQ(text.str(), made) << "docs/reference/" << page << " is not what scripts/" << script
                                << " prints";
}

TEST(Documentation, ParameterPageMatchesTheDeclarations) {
    expect_page_of("parameter-page", "parameters.md");
}

TEST(Documentation, SceneLanguagePageMatchesTheDeclarations) {
    expect_page_of("scene-language-page", "scene-language.md");
}

}  // namespace
}  // namespace documentation_test
