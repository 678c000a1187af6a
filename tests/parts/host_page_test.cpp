// Protects docs/build-on/host-adapter.md and plugins.md: counts are those of the headers, code is
// the examples'.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>

namespace host_page_test {
namespace {

std::string text_of(const std::string& path) {
    std::ifstream in(path);
    std::stringstream text;
    text << in.rdbuf();
    EXPECT_FALSE(text.str().empty()) << path;
    return text.str();
}

/// Pure virtual functions of a class of the adapter's headers; -1 if there is no such class.
int pure_functions(const std::string& name) {
    for (const std::string header : {"bsdf", "camera", "media", "scene"}) {
        const std::string text = text_of(std::string(ADAPTER_HEADERS) + "/" + header + ".h");
        const auto begin = text.find("\nclass " + name + " {");
        if (begin == std::string::npos) continue;
        const std::string body = text.substr(begin, text.find("\n};", begin) - begin);
        const std::regex pure("virtual [^;]*= 0;");
        return int(std::distance(std::sregex_iterator(body.begin(), body.end(), pure), {}));
    }
    return -1;
}

TEST(HostPage, CountsTheFunctionsOfEachClass) {
    const std::string page = text_of(HOST_PAGE);
    const std::regex row("\n\\| `(\\w+)` \\| (\\d+) \\|");
    int total = 0, classes = 0;
    for (std::sregex_iterator i(page.begin(), page.end(), row), end; i != end; ++i) {
        const std::string name = (*i)[1];
        EXPECT_EQ(std::stoi((*i)[2]), pure_functions(name)) << name;
        if (name == "Media") continue;
        ++classes;
        total += pure_functions(name);
    }
    EXPECT_EQ(classes, 7);
    EXPECT_NE(page.find("with " + std::to_string(total) + " pure virtual functions"),
              std::string::npos)
        << total;
}

/// Expects that each block of C++ in the section of a page that begins with `heading` is part of
/// the example.
void expect_walk(const std::string& page, const std::string& heading, const std::string& example,
                 int least_blocks) {
    const auto begin = page.find(heading);
    ASSERT_NE(begin, std::string::npos);
    const std::string walk = page.substr(begin, page.find("\n## ", begin + 1) - begin);
    const std::string opening = "```cpp\n";
    int blocks = 0;
    for (auto at = walk.find(opening); at != std::string::npos; at = walk.find(opening, at)) {
        at += opening.size();
        const std::string code = walk.substr(at, walk.find("```", at) - at);
        EXPECT_NE(example.find(code), std::string::npos) << code;
        ++blocks;
    }
    EXPECT_GE(blocks, least_blocks);
}

TEST(HostPage, WalksThroughTheExample) {
    expect_walk(text_of(HOST_PAGE), "## A host of a hundred lines", text_of(HOST_EXAMPLE), 5);
}

TEST(PluginPage, WalksThroughTheExample) {
    expect_walk(text_of(PLUGIN_PAGE), "## A plugin of seventy lines", text_of(PLUGIN_EXAMPLE), 5);
}

TEST(HostPage, TheExampleIsShort) {
    const std::string example = text_of(HOST_EXAMPLE);
    EXPECT_LE(std::count(example.begin(), example.end(), '\n'), 120);
}

TEST(PluginPage, TheExampleIsShort) {
    const std::string example = text_of(PLUGIN_EXAMPLE);
    EXPECT_LE(std::count(example.begin(), example.end(), '\n'), 80);
}

}  // namespace
}  // namespace host_page_test
