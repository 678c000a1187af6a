// Syntax: what is accepted, and the text of each syntax error.
#include <gtest/gtest.h>

#include "scene_fakes.h"

namespace lxs::test::syntax_test {
namespace {

/// Radius of the only sphere of `world`.
float radius_of(const std::string& world) {
    const SceneContents contents = read_world(world);
    const auto& quadric = std::get<Quadric>(contents.primitives.at(0).geometry);
    return std::get<Sphere>(quadric.shape).radius;
}

TEST(Syntax, AcceptsEveryWayToWriteANumber) {
    EXPECT_EQ(radius_of("Shape \"sphere\" \"float radius\" [2.5]"), 2.5f);
    EXPECT_EQ(radius_of("Shape \"sphere\" \"float radius\" 2.5"), 2.5f);
    EXPECT_EQ(radius_of("Shape \"sphere\" \"float radius\" [+.25e+1]"), 2.5f);
    EXPECT_EQ(radius_of("Shape \"sphere\" \"float radius\" [25.E-1]"), 2.5f);
    EXPECT_EQ(radius_of("Shape \"sphere\" \"float radius\" [1e-999]"), 0.0f);
    EXPECT_EQ(radius_of("Shape \"sphere\" \"float radius\" [0e999]"), 0.0f);
}

TEST(Syntax, IgnoresCommentsBlankLinesAndLineEnds) {
    EXPECT_EQ(
        radius_of("# \"\r\n\tShape\r\n\"sphere\" # here [\r\n\"float radius\"#x\r\n[#y\r\n4\r\n]"),
        4.0f);
}

TEST(Syntax, AcceptsAByteOrderMarkAndUtf8Names) {
    CollectingDiagnostics diagnostics;
    const SceneContents contents = read_text(
        "\xEF\xBB\xBFWorldBegin MakeNamedMaterial \"F\xC3\xBC\xC3\x9F"
        "e\" NamedMaterial \"F\xC3\xBC\xC3\x9F"
        "e\" Shape \"sphere\" WorldEnd",
        diagnostics);
    EXPECT_EQ(contents.material_names.at(0),
              "F\xC3\xBC\xC3\x9F"
              "e");
}

TEST(Syntax, BackslashEscapesQuoteAndBackslashOnly) {
    const SceneContents contents =
        read_world(R"(MakeNamedMaterial "a\"b\\c\d" NamedMaterial "a\"b\\c\d" Shape "sphere")");
    EXPECT_EQ(contents.material_names.at(0), R"(a"b\c\d)");
}

TEST(Syntax, ReadsBoolsAsStringsAndWords) {
    CollectingDiagnostics diagnostics;
    const SceneContents contents = read_text(
        "Film \"fleximage\" \"bool a\" [\"true\"] \"bool b\" \"false\" \"bool c\" [true] "
        "\"bool d\" false\nWorldBegin WorldEnd",
        diagnostics);
    const auto& values = contents.options.at("Film").parameters.values;
    const std::vector<bool> expected{true, false, true, false};
    ASSERT_EQ(values.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(std::get<std::vector<bool>>(values[i].values), std::vector<bool>{expected[i]});
    }
}

TEST(Syntax, KeepsWholeNumbersUpTo2To53) {
    CollectingDiagnostics diagnostics;
    const SceneContents contents = read_text(
        "Film \"fleximage\" \"integer n\" [9007199254740991 16777217]\nWorldBegin WorldEnd",
        diagnostics);
    const auto& values = contents.options.at("Film").parameters.values;
    EXPECT_EQ(std::get<std::vector<double>>(values.at(0).values),
              (std::vector<double>{9007199254740991.0, 16777217.0}));
}

TEST(Syntax, LocatesStatementsParametersAndValues) {
    CollectingDiagnostics diagnostics;
    const SceneContents contents = read_text(
        "Film \"fleximage\"\n  \"integer n\" [7\n 8]\nWorldBegin\n WorldEnd", diagnostics);
    const ParameterSet& set = contents.options.at("Film").parameters;
    EXPECT_EQ(set.where.line, 1u);
    EXPECT_EQ(set.where.column, 6u);
    const ParameterValue& value = set.values.at(0);
    EXPECT_EQ(value.where.line, 2u);
    EXPECT_EQ(value.where.column, 3u);
    ASSERT_EQ(value.value_where.size(), 2u);
    EXPECT_EQ(value.value_where[1].line, 3u);
    EXPECT_EQ(value.value_where[1].column, 2u);
    EXPECT_EQ(contents.end.line, 5u);
    EXPECT_EQ(contents.end.column, 2u);
}

TEST(SyntaxError, ShowsLineAndCaret) {
    EXPECT_EQ(error_of_text("WorldBegin\nShape \"sphere\" \"float radius\" [1.2.3]\n"),
              "test.lxs:2:32: error: \"1.2.3\" is not a number\n"
              "  Shape \"sphere\" \"float radius\" [1.2.3]\n"
              "                                 ^");
}

TEST(SyntaxError, NumberGarbage) {
    const auto error = [](const std::string& number) {
        return error_of_world("Shape \"sphere\" \"float radius\" [" + number + "]");
    };
    for (const std::string number :
         {"12abc", "1e", "1-2", "-", ".", "+-1", "0x10", "1.5f", "1,5"}) {
        const std::string message = error(number);
        EXPECT_TRUE(message == "test.lxs:2:32: error: \"" + number + "\" is not a number" ||
                    number == "1,5")
            << message;
    }
    EXPECT_EQ(error("1,5"),
              "test.lxs:2:33: error: expected a number, a string or ']' in the list that begins at "
              "2:31, found \",5\"");
}

TEST(SyntaxError, NumbersThatAreNotFinite) {
    const std::string far = "-1" + std::string(400, '0');
    for (const std::string number : {"nan", "-inf", "NaN", "+Infinity", "1.#INF", "-1.#IND00",
                                     "-nan(ind)", "1e39", far.c_str()}) {
        EXPECT_EQ(error_of_world("Translate 0 " + number + " 0"),
                  "test.lxs:2:13: error: Translate takes finite numbers, at most 3.4e38");
        EXPECT_EQ(error_of_world("Shape \"sphere\" \"float radius\" [" + number + "]"),
                  "test.lxs:2:32: error: sphere: \"radius\" takes finite numbers, at most 3.4e38");
    }
}

TEST(SyntaxError, UnterminatedString) {
    EXPECT_EQ(error_of_world("Shape \"sphere"),
              "test.lxs:2:7: error: this string has no closing quote on its line");
    EXPECT_EQ(error_of_text("Film \"x"),
              "test.lxs:1:6: error: this string has no closing quote on its line\n"
              "  Film \"x\n       ^");
    EXPECT_EQ(error_of_text("Film \"x\\\""),
              "test.lxs:1:6: error: this string has no closing quote on its line\n"
              "  Film \"x\\\"\n       ^");
}

TEST(SyntaxError, ControlCharacterInString) {
    EXPECT_EQ(first_line(error_of_text(std::string("Film \"a\0b\"", 10))),
              "test.lxs:1:8: error: control character 0x00 in a string");
}

TEST(SyntaxError, UnterminatedList) {
    EXPECT_EQ(first_line(error_of_text("Film \"x\" \"float a\" [1 2\n")),
              "test.lxs:1:20: error: this list has no closing ']'");
    EXPECT_EQ(error_of_world("Shape \"sphere\" \"float radius\" [1\nShape \"sphere\""),
              "test.lxs:3:1: error: expected a number, a string or ']' in the list that begins at "
              "2:31, found \"Shape\"");
}

TEST(SyntaxError, NestedLists) {
    const std::string brackets(100000, '[');
    EXPECT_EQ(error_of_world("Transform " + brackets),
              "test.lxs:2:12: error: lists do not nest: '[' inside of a list");
}

TEST(SyntaxError, MixedList) {
    EXPECT_EQ(
        error_of_world("Shape \"sphere\" \"float radius\" [1 \"a\"]"),
        "test.lxs:2:34: error: a list holds either numbers or strings or bools, not a mixture");
}

TEST(SyntaxError, StrayCharacters) {
    EXPECT_EQ(first_line(error_of_text("]")),
              "test.lxs:1:1: error: expected a statement, found \"]\"");
    EXPECT_EQ(first_line(error_of_text("\"a\"")),
              "test.lxs:1:1: error: expected a statement, found \"\"\"");
    EXPECT_EQ(error_of_world("; x"), "test.lxs:2:1: error: expected a statement, found \";\"");
    EXPECT_EQ(error_of_world("\x01"), "test.lxs:2:1: error: expected a statement, found \"?\"");
}

TEST(SyntaxError, ParameterForms) {
    EXPECT_EQ(error_of_world("Shape \"sphere\" \"radius\" [1]"),
              "test.lxs:2:16: error: a parameter begins with \"type name\", found \"radius\"");
    EXPECT_EQ(
        error_of_world("Shape \"sphere\" \"flot radius\" [1]"),
        "test.lxs:2:16: error: unknown parameter type \"flot\"; did you mean \"float\"? Known: "
        "float, integer, bool, point, vector, normal, string, texture, color, rgb");
    EXPECT_EQ(error_of_world("Shape \"sphere\" \"float radius\""),
              "test.lxs:2:16: error: parameter \"radius\" has no value");
    EXPECT_EQ(error_of_world("Shape \"sphere\" \"float radius\" \"float zmin\" [1]"),
              "test.lxs:2:16: error: parameter \"radius\" has no value");
    EXPECT_EQ(error_of_world("Shape \"sphere\" \"point P\" 1 2 3"),
              "test.lxs:2:26: error: several values stand in [ ]");
    EXPECT_EQ(error_of_world("Shape \"sphere\" [1]"),
              "test.lxs:2:16: error: expected a parameter, \"type name\", found a list; several "
              "values stand in [ ]");
}

}  // namespace
}  // namespace lxs::test::syntax_test
