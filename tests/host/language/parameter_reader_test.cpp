// Parameters against their declarations: values, leniency, and the text of every complaint.
#include <gtest/gtest.h>

#include <array>

#include "scene_fakes.h"

namespace lxs::test::parameter_reader_test {
namespace {

using Type = ParameterType;
using Numbers = std::vector<double>;
using Strings = std::vector<std::string>;
using Bools = std::vector<bool>;

constexpr std::array<std::string_view, 2> kModes = {"progressive", "photonmap"};
constexpr std::array kDeclarations = {
    ParameterDeclaration{.name = "alpha", .type = Type::Float, .minimum = 0, .maximum = 1},
    ParameterDeclaration{.name = "count", .type = Type::Integer, .minimum = 1},
    ParameterDeclaration{.name = "half", .type = Type::Bool},
    ParameterDeclaration{.name = "mode", .type = Type::String, .choices = kModes},
    ParameterDeclaration{.name = "L", .type = Type::Color},
    ParameterDeclaration{.name = "from", .type = Type::Point},
    ParameterDeclaration{.name = "P", .type = Type::Point, .array = true},
    ParameterDeclaration{.name = "sigma", .type = Type::FloatTexture},
    ParameterDeclaration{.name = "Kd", .type = Type::ColorTexture},
    ParameterDeclaration{.name = "fresnel", .type = Type::FresnelTexture},
    ParameterDeclaration{.name = "old", .type = Type::Float, .no_effect = true},
    ParameterDeclaration{.name = "older", .type = Type::String, .no_effect = true},
    ParameterDeclaration{.name = "along", .type = Type::Float, .minimum = 0, .older_name = "both"},
    ParameterDeclaration{.name = "across", .type = Type::Float, .minimum = 0, .older_name = "both"},
};

template <class Values>
ParameterValue value(const std::string& type, const std::string& name, Values values) {
    return {type, name, std::move(values), {}, {}};
}

ParameterSet set_of(std::vector<ParameterValue> values) {
    ParameterSet set;
    set.plugin = "thing";
    set.values = std::move(values);
    return set;
}

std::string error_of(ParameterValue value) {
    CollectingDiagnostics diagnostics;
    const ParameterSet set = set_of({std::move(value)});
    try {
        const ParameterReader reader(set, kDeclarations, diagnostics);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

std::vector<std::string> warnings_of(std::vector<ParameterValue> values) {
    CollectingDiagnostics diagnostics;
    const ParameterSet set = set_of(std::move(values));
    const ParameterReader reader(set, kDeclarations, diagnostics);
    return diagnostics.messages;
}

TEST(ParameterReader, ReadsEachType) {
    CollectingDiagnostics diagnostics;
    const ParameterSet set = set_of({
        value("float", "alpha", Numbers{0.25}),
        value("integer", "count", Numbers{9007199254740992.0}),
        value("bool", "half", Bools{true}),
        value("string", "mode", Strings{"photonmap"}),
        value("color", "L", Numbers{1, 2, 3}),
        value("point", "from", Numbers{4, 5, 6}),
        value("point", "P", Numbers{0, 1, 2, 3, 4, 5}),
        value("texture", "Kd", Strings{"wood"}),
        value("float", "sigma", Strings{"noise"}),
    });
    const ParameterReader reader(set, kDeclarations, diagnostics);
    EXPECT_EQ(reader.number("alpha", 0), 0.25);
    EXPECT_EQ(reader.integer("count", 0), 9007199254740992);
    EXPECT_TRUE(reader.boolean("half", false));
    EXPECT_EQ(reader.string("mode", ""), "photonmap");
    EXPECT_EQ(reader.color("L", Rgb(0.0f)), Rgb(1, 2, 3));
    EXPECT_EQ(reader.vector("from", Vec3(0.0f)), Vec3(4, 5, 6));
    EXPECT_EQ(reader.numbers("P").size(), 6u);
    EXPECT_EQ(reader.texture_name("Kd"), "wood");
    EXPECT_EQ(reader.texture_name("sigma"), "noise");
    EXPECT_TRUE(diagnostics.messages.empty());
}

TEST(ParameterReader, GivesFallbacksForWhatIsMissing) {
    CollectingDiagnostics diagnostics;
    const ParameterSet set = set_of({});
    const ParameterReader reader(set, kDeclarations, diagnostics);
    EXPECT_FALSE(reader.given("alpha"));
    EXPECT_EQ(reader.number("alpha", 0.5), 0.5);
    EXPECT_EQ(reader.integer("count", 7), 7);
    EXPECT_TRUE(reader.boolean("half", true));
    EXPECT_EQ(reader.string("mode", "x"), "x");
    EXPECT_EQ(reader.color("L", Rgb(2.0f)), Rgb(2.0f));
    EXPECT_TRUE(reader.numbers("P").empty());
    EXPECT_EQ(reader.texture_name("Kd"), std::nullopt);
}

TEST(ParameterReader, TakesWholeFloatsAndIntegersForOneAnother) {
    EXPECT_EQ(error_of(value("float", "count", Numbers{3})), "");
    EXPECT_EQ(error_of(value("integer", "alpha", Numbers{1})), "");
    EXPECT_EQ(error_of(value("rgb", "L", Numbers{1, 1, 1})), "");
    EXPECT_EQ(error_of(value("float", "fresnel", Numbers{1.5})), "");
    EXPECT_EQ(error_of(value("color", "Kd", Strings{"named"})), "");
}

TEST(ParameterReader, ReadsAnOlderNameAsTodays) {
    CollectingDiagnostics diagnostics;
    const ParameterSet set =
        set_of({value("float", "both", Numbers{2}), value("float", "across", Numbers{3})});
    const ParameterReader reader(set, kDeclarations, diagnostics);
    EXPECT_TRUE(reader.given("along"));
    EXPECT_EQ(reader.number("along", 0), 2);
    EXPECT_EQ(reader.spelling("along"), "both");
    EXPECT_EQ(reader.number("across", 0), 3);
    EXPECT_EQ(reader.spelling("across"), "across");
    EXPECT_EQ(reader.spelling("alpha"), "alpha");
    EXPECT_EQ(error_of(value("float", "both", Numbers{-1})),
              "error: thing: \"both\" is out of range: -1 is not at least 0");
}

TEST(ParameterReader, SaysWhichOfTwoNamesIsUsed) {
    const auto both = value("float", "both", Numbers{2});
    const auto along = value("float", "along", Numbers{1}),
               across = value("float", "across", Numbers{1});
    using Messages = std::vector<std::string>;
    EXPECT_EQ(warnings_of({both, along}),
              Messages{"warning: thing: \"along\" is used in place of \"both\""});
    EXPECT_EQ(warnings_of({across, both, along}),
              Messages{"warning: thing: \"along\", \"across\" are used in place of \"both\""});
    EXPECT_EQ(warnings_of({value("float", "both", Numbers{1}), along, across}), Messages{});
}

TEST(ParameterReader, NamesExpectedAndFoundTypes) {
    EXPECT_EQ(
        error_of(value("string", "alpha", Strings{"x"})),
        "error: thing: \"alpha\" takes \"float alpha\" [number], found a value of type string");
    EXPECT_EQ(
        error_of(value("float", "Kd", Numbers{1})),
        "error: thing: \"Kd\" takes \"color Kd\" [r g b] or \"texture Kd\" [\"name\"], found a "
        "value of type float");
    EXPECT_EQ(error_of(value("vector", "from", Numbers{1, 2, 3})),
              "error: thing: \"from\" takes \"point from\" [x y z], found a value of type vector");
    EXPECT_EQ(error_of(value("float", "alpha", Strings{"noise"})),
              "error: thing: \"alpha\" takes \"float alpha\" [number], found a value of type float "
              "naming a texture");
    EXPECT_EQ(error_of(value("bool", "half", Strings{"yes"})),
              "error: thing: \"half\" takes \"true\" or \"false\", found \"yes\"");
    EXPECT_EQ(
        error_of(value("string", "mode", Bools{true})),
        "error: thing: \"mode\" takes \"string mode\" [\"text\"], found a value of type string "
        "holding bools");
    EXPECT_EQ(
        error_of(value("string", "mode", Numbers{1})),
        "error: thing: \"mode\" takes \"string mode\" [\"text\"], found a value of type string "
        "holding numbers");
}

TEST(ParameterReader, ChecksCounts) {
    EXPECT_EQ(error_of(value("float", "alpha", Numbers{})), "error: thing: \"alpha\" has no value");
    EXPECT_EQ(error_of(value("float", "alpha", Numbers{0, 1})),
              "error: thing: \"alpha\" takes 1 number, found 2");
    EXPECT_EQ(error_of(value("color", "L", Numbers{1})),
              "error: thing: \"L\" takes 3 numbers, found 1");
    EXPECT_EQ(error_of(value("point", "P", Numbers{1, 2, 3, 4})),
              "error: thing: \"P\" takes numbers in groups of 3, found 4");
    EXPECT_EQ(error_of(value("string", "mode", Strings{"photonmap", "photonmap"})),
              "error: thing: \"mode\" takes one value, found 2");
}

TEST(ParameterReader, ChecksRangesAndWholeNumbers) {
    EXPECT_EQ(error_of(value("float", "alpha", Numbers{1.5})),
              "error: thing: \"alpha\" is out of range: 1.5 is not between 0 and 1");
    EXPECT_EQ(error_of(value("integer", "count", Numbers{0})),
              "error: thing: \"count\" is out of range: 0 is not at least 1");
    EXPECT_EQ(error_of(value("float", "count", Numbers{2.5})),
              "error: thing: \"count\" takes a whole number of at most 2^53, found 2.5");
    EXPECT_EQ(error_of(value("integer", "count", Numbers{1e17})),
              "error: thing: \"count\" takes a whole number of at most 2^53, found 1e+17");
}

TEST(ParameterReader, ListsChoicesNearestFirst) {
    EXPECT_EQ(error_of(value("string", "mode", Strings{"photonmaps"})),
              "error: thing: unknown mode \"photonmaps\"; did you mean \"photonmap\"? "
              "Known: photonmap, progressive");
}

TEST(ParameterReader, WarnsOfUnknownNamesWithTheNearest) {
    EXPECT_EQ(warnings_of({value("float", "alhpa", Numbers{1})}),
              (Strings{"warning: thing: unknown parameter \"alhpa\"; did you mean \"alpha\"?"}));
    EXPECT_EQ(warnings_of({value("float", "zzzzzz", Numbers{1})}),
              (Strings{"warning: thing: unknown parameter \"zzzzzz\""}));
}

TEST(ParameterReader, LastOfTwoCounts) {
    CollectingDiagnostics diagnostics;
    const ParameterSet set = set_of(
        {value("float", "alpha", Strings{"ignored"}), value("float", "alpha", Numbers{0.75})});
    const ParameterReader reader(set, kDeclarations, diagnostics);
    EXPECT_EQ(reader.number("alpha", 0), 0.75);
    EXPECT_EQ(diagnostics.messages,
              (Strings{"warning: \"alpha\" is given twice: the last one counts"}));
}

/// What a reader says that goes on where LuxRender does.
std::vector<std::string> said_of(const ParameterSet& set) {
    LenientDiagnostics diagnostics;
    const ParameterReader reader(set, kDeclarations, diagnostics);
    return diagnostics.messages;
}

TEST(ParameterReader, MendsWhatLuxRenderGoesOnFrom) {
    LenientDiagnostics diagnostics;
    const ParameterSet set = set_of({
        value("float", "alpha", Numbers{7}),
        value("integer", "count", Numbers{2.75}),
        value("bool", "half", Strings{"yes"}),
        value("string", "mode", Strings{"progresive"}),
        value("float", "L", Numbers{1, 2, 3}),
        value("point", "from", Numbers{1, 2}),
        value("flaot", "along", Numbers{5}),
    });
    const ParameterReader reader(set, kDeclarations, diagnostics);
    EXPECT_EQ(reader.number("alpha", 0), 1) << "the nearest in range";
    EXPECT_EQ(reader.integer("count", 0), 2) << "cast to an integer";
    EXPECT_FALSE(reader.boolean("half", true));
    EXPECT_EQ(reader.string("mode", "photonmap"), "photonmap");
    EXPECT_EQ(reader.color("L", Rgb(0.5f)), Rgb(0.5f));
    EXPECT_EQ(reader.vector("from", Vec3(9)), Vec3(9));
    EXPECT_FALSE(reader.given("along"));
    EXPECT_EQ(diagnostics.messages.size(), 7u);
    EXPECT_EQ(diagnostics.messages[0],
              "warning: thing: \"alpha\" is out of range: 7 is not between 0 and 1; 1 is used");
    EXPECT_EQ(diagnostics.messages[2],
              "warning: thing: \"half\" takes \"true\" or \"false\", found \"yes\"; false is used");
}

/// LuxRender takes as many whole colours and points as the numbers make.
TEST(ParameterReader, NumbersBehindTheLastWholeTripleAreLeftOut) {
    LenientDiagnostics diagnostics;
    const ParameterSet set = set_of({value("color", "L", Numbers{1, 0, 0, 1}),
                                     value("point", "P", Numbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9})});
    const ParameterReader reader(set, kDeclarations, diagnostics);
    EXPECT_EQ(reader.color("L", Rgb(0.5f)), Rgb(1, 0, 0));
    EXPECT_EQ(reader.numbers("P").size(), 9u);
    EXPECT_EQ(diagnostics.messages,
              (Strings{"warning: thing: \"L\" takes 3 numbers, found 4; the first 3 are used",
                       "warning: thing: \"P\" takes numbers in groups of 3, found 10; the first 9 "
                       "are used"}));
    // Two colours are not one.
    const ParameterSet two = set_of({value("color", "L", Numbers{1, 0, 0, 0, 1, 0})});
    EXPECT_EQ(ParameterReader(two, kDeclarations, diagnostics).color("L", Rgb(0.5f)), Rgb(0.5f));
}

TEST(ParameterReader, AnOverriddenValueDoesNotComeBackForAWrongOne) {
    LenientDiagnostics diagnostics;
    const ParameterSet set = set_of(
        {value("float", "alpha", Strings{"unchecked"}), value("color", "alpha", Numbers{1, 2, 3})});
    const ParameterReader reader(set, kDeclarations, diagnostics);
    EXPECT_FALSE(reader.given("alpha"));
    EXPECT_EQ(said_of(set).size(), 2u);
}

TEST(ParameterReader, CopiesOfAReaderOfMendedValuesStandAlone) {
    LenientDiagnostics diagnostics;
    const ParameterSet set = set_of({value("float", "alpha", Numbers{7})});
    auto reader = std::make_unique<ParameterReader>(set, kDeclarations, diagnostics);
    const ParameterReader copy = *reader;
    reader.reset();
    EXPECT_EQ(copy.number("alpha", 0), 1);
}

TEST(ParameterReader, SaysOnceWhatHasNoEffect) {
    EXPECT_EQ(
        warnings_of({value("float", "old", Numbers{1}), value("string", "older", Strings{"x"})}),
        (Strings{"warning: thing: \"old\", \"older\" have no effect here"}));
}

TEST(ParameterReader, NeverHandsOutAValueOfAnotherKind) {
    CollectingDiagnostics diagnostics;
    const ParameterSet set = set_of({value("string", "undeclared", Strings{"x"})});
    const ParameterReader reader(set, kDeclarations, diagnostics);
    EXPECT_EQ(reader.number("undeclared", 4), 4);
    EXPECT_FALSE(reader.boolean("undeclared", false));
}

}  // namespace
}  // namespace lxs::test::parameter_reader_test
