// Protects the command line: what each option does, and the messages and exit codes of mistakes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "lxs/language/read_scene.h"
#include "lxsrender_process.h"

namespace lxs::test::command_line_test {
namespace {

using testing::HasSubstr;

class CommandLineTest : public testing::Test {
  protected:
    RunResult run(std::vector<std::string> arguments, const std::string& input = "") {
        return run_lxsrender(folder_, std::move(arguments), input);
    }
    TemporaryFolder folder_;
};

TEST_F(CommandLineTest, HelpNamesOptionsAndExitCodes) {
    const RunResult result = run({"--help"});
    EXPECT_EQ(result.exit_code, 0);
    for (const char* text : {"SCENE.lxs", "--passes", "--time", "--set", "--strict", "--stats",
                             "Exit codes:", "130  interrupted"}) {
        EXPECT_THAT(result.out, HasSubstr(text));
    }
}

// The scene may stand behind an option that may be repeated.
TEST_F(CommandLineTest, RepeatableOptionsTakeOneValueEach) {
    folder_.write("scene.lxs", small_scene());
    const RunResult result =
        run({"--set", "path.maxdepth=2", "--plugin-path",
             std::string(TEST_MODULES) + "/troublesome", "scene.lxs", "--passes", "1", "--set",
             "path.rrcontinueprob=0.5", "--integrator", "path", "--verbose"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("path: maxdepth 2 bounces"));
    EXPECT_THAT(result.err, HasSubstr("rrcontinueprob 0.5"));
}

TEST_F(CommandLineTest, VersionIsPrinted) {
    const RunResult result = run({"--version"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.out, testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST_F(CommandLineTest, MistakesExitWithTwoAndSayWhatIsWrong) {
    const struct {
        std::vector<std::string> arguments;
        std::string message;
    } cases[] = {
        {{}, "SCENE.lxs is required"},
        {{"a.lxs", "--bogus"}, "unknown option \"--bogus\"\nRun"},
        {{"a.lxs", "--pases", "4"}, "unknown option \"--pases\"; did you mean --passes?"},
        {{"--itnegrator=path", "a.lxs"}, "\"--itnegrator\"; did you mean --integrator?"},
        {{"a.lxs", "b.lxs"}, "The following argument was not expected: b.lxs"},
        {{"a.lxs", "--passes", "0"}, "--passes"},
        {{"a.lxs", "--passes", "many"}, "--passes"},
        {{"a.lxs", "--time", "-1"}, "expected a number above 0, found \"-1\""},
        {{"a.lxs", "--passes", "1", "--time", "1"}, "excludes"},
        {{"a.lxs", "--threads", "0"}, "--threads"},
        {{"a.lxs", "--set", "maxdepth=3"}, "expected plugin.parameter=value, found"},
        {{"a.lxs", "-o", "a.jpg"}, "the name must end in .exr or .png: a.jpg"},
        {{"a.lxs", "-o", "a"}, "the name must end in .exr or .png: a"},
        {{"a.lxs", "--exposure", "nan"}, "--exposure"},
        {{"a.lxs", "--exposure", "65"}, "--exposure"},
        {{"a.lxs", "--layers", "depth,albdo"}, "\"albdo\"; did you mean \"albedo\"? Known: "},
        {{"a.lxs", "--denoise=first"}, "--denoise: expected last, found \"first\""},
        {{"a.lxs", "--quiet", "--verbose"}, "excludes"},
        {{"--markdown"}, "--describe"},
        {{"--describe", "pth"}, "unknown plugin \"pth\"; did you mean \"path\"?"},
        {{"--describe", "carpiant"}, "unknown plugin \"carpiant\"; did you mean \"carpaint\"?"},
        {{"--describe", "no-such"},
         "unknown plugin \"no-such\"; --describe knows the names that Accelerator, "},
    };
    for (const auto& [arguments, message] : cases) {
        const RunResult result = run(arguments);
        EXPECT_EQ(result.exit_code, 2) << message;
        EXPECT_THAT(result.err, HasSubstr(message));
    }
}

TEST_F(CommandLineTest, ListPluginsNamesTheIntegratorsThatComeWithTheRenderer) {
    const RunResult result = run({"--list-plugins"});
    EXPECT_EQ(result.exit_code, 0);
    for (const char* name : {"aips ", "exphotonmap ", "path ", "ppm ", "sppm "}) {
        EXPECT_THAT(result.out, HasSubstr(name));
    }
}

TEST_F(CommandLineTest, DescribeListsParametersOfIntegratorsAndOfTheHostsOwnPlugins) {
    const RunResult path = run({"--describe", "path"});
    EXPECT_EQ(path.exit_code, 0);
    EXPECT_THAT(path.out, HasSubstr("SurfaceIntegrator \"path\""));
    EXPECT_THAT(path.out, HasSubstr("maxdepth"));
    EXPECT_THAT(run({"--describe", "path", "--markdown"}).out,
                HasSubstr("| maxdepth | integer | 16 |"));
    const RunResult matte = run({"--describe", "matte"});
    EXPECT_THAT(matte.out, HasSubstr("Material \"matte\""));
    EXPECT_THAT(matte.out, HasSubstr("sigma"));
    EXPECT_THAT(run({"--describe", "fleximage"}).out, HasSubstr("Film \"fleximage\""));
    EXPECT_THAT(run({"--describe", "perspective"}).out, HasSubstr("screenwindow"));
    EXPECT_THAT(run({"--describe", "multi"}).out,
                HasSubstr("VolumeIntegrator \"multi\"\n\n  no parameters are read"));
}

TEST_F(CommandLineTest, DescribeKnowsEveryKindOfStatement) {
    for (const auto& [kind, names] : known_plugin_names()) {
        const RunResult result = run({"--describe", kind == "MakeNamedVolume" ? "Volume" : kind});
        EXPECT_EQ(result.exit_code, 0) << kind << result.err;
        const RunResult first = run({"--describe", names.back()});
        EXPECT_EQ(first.exit_code, 0) << kind << " " << names.back();
    }
    EXPECT_THAT(run({"--describe", "Texture"}).out,
                testing::AllOf(HasSubstr("Texture color: "), HasSubstr("Texture fresnel: ")));
    EXPECT_THAT(run({"--describe", "Material"}).out, HasSubstr("matte, mattetranslucent"));
    EXPECT_THAT(run({"--describe", "Materail"}).err, HasSubstr("did you mean \"Material\"?"));
}

// Each option stands in a group, with words for its value, in lines that a terminal shows whole.
TEST_F(CommandLineTest, HelpIsForReaders) {
    const std::string help = run({"--help"}).out;
    for (const char* text : {"When to stop (default: as the scene says, or 16 passes):",
                             "What to write:", "--threads COUNT\n", "1 to 1024",
                             "Examples:", "lxsrender scene.lxs --integrator aips --time 60"}) {
        EXPECT_THAT(help, HasSubstr(text));
    }
    for (const char* text : {"Options:", "value in", "->", "{false}", " in [", "e+"})
        EXPECT_THAT(help, testing::Not(HasSubstr(text)));
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line) && line != "Exit codes:";)
        EXPECT_LE(line.size(), 79u) << line;
}

TEST_F(CommandLineTest, TargetErrorsAreSharesOrPerCent) {
    folder_.write("scene.lxs", small_scene());
    for (const char* error : {"5", "0", "-0.05", "105%", "inf", "x", "5 %%"}) {
        const RunResult result = run({"scene.lxs", "--target-error", error});
        EXPECT_EQ(result.exit_code, 2) << error;
        EXPECT_THAT(result.err, HasSubstr("as 0.05, or in per cent, as 5%; found \"")) << error;
    }
    EXPECT_THAT(run({"scene.lxs", "--target-error", "5"}).err, HasSubstr("did you mean 5%?"));
    for (const char* error : {"0.9", "90%"}) {
        EXPECT_THAT(run({"scene.lxs", "--target-error", error, "--passes", "4"}).err,
                    HasSubstr("until the error is 90 %"))
            << error;
    }
}

TEST_F(CommandLineTest, SceneComesFromStandardInputForADash) {
    const RunResult result = run({"-", "--passes", "1"}, small_scene());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(folder_.has("out.exr"));
    EXPECT_TRUE(folder_.has("out.png"));
}

TEST_F(CommandLineTest, SetOverridesTheScenesParameter) {
    folder_.write("a.lxs", small_scene("SurfaceIntegrator \"path\" \"integer maxdepth\" [9]"));
    const RunResult result = run({"a.lxs", "--passes", "1", "--set", "path.maxdepth=3", "--set",
                                  "path.directlightsampling=false", "--verbose"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("maxdepth 3 bounces"));
    EXPECT_THAT(result.err, HasSubstr("directlightsampling false"));
}

TEST_F(CommandLineTest, BadOverridesAreErrorsThatNameTheOption) {
    folder_.write("a.lxs", small_scene());
    const struct {
        std::string set, message;
    } cases[] = {
        {"pth.maxdepth=3", "command line: --set pth.maxdepth=3: error: unknown integrator \"pth\""},
        {"path.maxdeth=3", "unknown path parameter \"maxdeth\"; did you mean \"maxdepth\"?"},
        {"path.maxdepth=deep", "expected a number, found \"deep\""},
        {"path.maxdepth=-3", "\"maxdepth\" is out of range"},
        {"path.includeenvironment=yes", "expected true or false, found \"yes\""},
        {"path.rrstrategy=lucky", "\"lucky\"; known: efficiency, probability, none"},
    };
    for (const auto& [set, message] : cases) {
        const RunResult result = run({"a.lxs", "--passes", "1", "--set", set});
        EXPECT_EQ(result.exit_code, 3) << set;
        EXPECT_THAT(result.err, HasSubstr(message));
        EXPECT_THAT(result.err, HasSubstr("command line: --set " + set));
    }
}

TEST_F(CommandLineTest, OverrideOfAnotherIntegratorWarns) {
    folder_.write("a.lxs", small_scene());
    const RunResult result = run({"a.lxs", "--passes", "1", "--set", "sppm.alpha=0.5"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("--set sppm.alpha=0.5 has no effect"));
}

TEST_F(CommandLineTest, IntegratorOverridesTheSceneAndKeepsWhatItDeclares) {
    folder_.write("a.lxs", small_scene("Renderer \"sppm\"\n"
                                       "SurfaceIntegrator \"sppm\" \"float alpha\" [0.5]\n"
                                       "  \"bool includeenvironment\" [\"false\"]"));
    const RunResult result = run({"a.lxs", "--passes", "1", "--integrator", "path", "--verbose"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("parameters unknown to \"path\" are left out: alpha"));
    EXPECT_THAT(result.err, HasSubstr("includeenvironment false"));
}

TEST_F(CommandLineTest, UnknownIntegratorListsTheKnownOnes) {
    folder_.write("a.lxs", small_scene());
    const RunResult result = run({"a.lxs", "--integrator", "pathh"});
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.err,
                HasSubstr("command line: --integrator pathh: error: unknown SurfaceIntegrator "
                          "\"pathh\"; did you mean \"path\"? Known: path, aips"));
}

TEST_F(CommandLineTest, RendererImpliesItsIntegrator) {
    folder_.write("a.lxs", small_scene("Renderer \"sppm\""));
    const RunResult result = run({"a.lxs", "--passes", "1"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("with \"sppm\""));
}

TEST_F(CommandLineTest, QuietSaysNothingAboutAHealthyRender) {
    folder_.write("a.lxs", small_scene());
    const RunResult result = run({"a.lxs", "--passes", "1", "--quiet"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(result.out, "");
}

/// What `text` says, without times.
std::vector<std::string> lines_without_times(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(std::regex_replace(text, std::regex("\\d+:\\d\\d"), "T"));
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

// Whoever does not know the engine understands each line.
TEST_F(CommandLineTest, PlainRenderSaysOnlyWhatEverybodyUnderstands) {
    folder_.write("a.lxs", small_scene());
    for (const std::string integrator : {"path", "aips"}) {
        const RunResult result = run({"a.lxs", "--passes", "2", "--integrator", integrator});
        std::vector<std::string> lines = lines_without_times(result.err);
        if (integrator == "aips") {
            EXPECT_THAT(lines.back(), testing::StartsWith("photons brought "));
            lines.pop_back();
        }
        EXPECT_THAT(lines,
                    testing::ElementsAre(
                        "scene: 1 round shape (spheres, disks, ...), 1 light, 1 material; the "
                        "image has 8 x 6 pixels",
                        "rendering 2 passes with \"" + integrator +
                            "\"; Ctrl-C ends it early and keeps the picture",
                        "pass 1 of 2, T gone, about T left",
                        "rendered 2 passes in T: as many as --passes asks for",
                        "wrote out.exr and out.png"));
    }
}

TEST_F(CommandLineTest, VerboseAddsWhatTheEngineDoes) {
    folder_.write("a.lxs", small_scene());
    const RunResult result =
        run({"a.lxs", "--passes", "1", "--integrator", "aips", "--seed", "5", "--verbose"});
    for (const char* text :
         {"engine: mode = ", "plan: ", "engine memory: its settings bound it by ",
          "memory: at most ", "skipped ", "seed 5\n", " rays/s, memory "})
        EXPECT_THAT(result.err, HasSubstr(text));
}

TEST_F(CommandLineTest, VerboseSaysWhatTheSceneDoesNotNeed) {
    folder_.write("a.lxs", small_scene());
    const RunResult result = run({"a.lxs", "--passes", "1", "--verbose"});
    EXPECT_THAT(result.err, HasSubstr("skipped, as the scene has none: image textures (no texture "
                                      "system), media, motion"));
}

TEST_F(CommandLineTest, StrictTurnsUnknownParametersIntoErrors) {
    folder_.write("a.lxs", small_scene("SurfaceIntegrator \"path\" \"integer maxdeph\" [3]"));
    const RunResult lax = run({"a.lxs", "--passes", "1"});
    EXPECT_EQ(lax.exit_code, 0);
    EXPECT_THAT(lax.err, HasSubstr("warning: path: unknown parameter \"maxdeph\"; did you mean "
                                   "\"maxdepth\"?"));
    const RunResult strict = run({"a.lxs", "--passes", "1", "--strict"});
    EXPECT_EQ(strict.exit_code, 3);
    EXPECT_THAT(strict.err, HasSubstr("error: path: unknown parameter \"maxdeph\""));
}

}  // namespace
}  // namespace lxs::test::command_line_test
