// Protects the loading of plugin modules: each way in which one can be wrong has its own message.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "lxs/sdk/plugin.h"
#include "lxsrender_process.h"

namespace lxs::test::plugin_module_test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

constexpr const char* kTroublesome = TEST_MODULES "/troublesome";

class PluginModuleTest : public testing::Test {
  protected:
    RunResult list(const std::string& plugin_folder) {
        return run_lxsrender(folder_, {"--list-plugins", "--plugin-path", plugin_folder});
    }
    RunResult render(const std::string& integrator) {
        folder_.write("scene.lxs", small_scene());
        return run_lxsrender(folder_, {"scene.lxs", "--passes", "1", "--integrator", integrator,
                                       "--plugin-path", kTroublesome});
    }
    TemporaryFolder folder_;
};

TEST_F(PluginModuleTest, AnotherAbiVersion) {
    const RunResult result = list(TEST_MODULES "/wrong_abi");
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_THAT(result.err, HasSubstr(fmt::format("wrong_abi.so': built for version {} of the "
                                                  "plugin SDK, but this lxsrender has version {}; "
                                                  "build the module again",
                                                  lxs::kAbiVersion + 41, lxs::kAbiVersion)));
}

TEST_F(PluginModuleTest, EntryFunctionThatThrows) {
    const RunResult result = list(TEST_MODULES "/throwing_entry");
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_THAT(result.err, HasSubstr("throwing_entry.so': its entry function failed: the licence "
                                      "has run out"));
}

TEST_F(PluginModuleTest, NoEntryFunction) {
    const RunResult result = list(TEST_MODULES "/no_entry");
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_THAT(result.err, HasSubstr("no_entry.so': no plugin of lxsrender: it has no function "
                                      "lxs_plugin_module"));
}

TEST_F(PluginModuleTest, NameThatIsAlreadyTaken) {
    const RunResult result = list(TEST_MODULES "/duplicate_name");
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_THAT(result.err, HasSubstr("integrator \"path\" is already offered by '"));
    EXPECT_THAT(result.err, HasSubstr("duplicate_name.so'"));
}

TEST_F(PluginModuleTest, FileThatIsNoSharedLibrary) {
    folder_.write("broken.so", "this is no shared library");
    const RunResult result = list(folder_.path().string());
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_THAT(result.err, HasSubstr("broken.so': can't be loaded: file too short\n"));
}

/// The loader maps what is not there, and the process would end with SIGBUS at its first use.
TEST_F(PluginModuleTest, FileThatIsCutShort) {
    const std::string module = TEST_MODULES "/no_entry/no_entry.so";
    const auto size = std::filesystem::file_size(module);
    std::filesystem::copy_file(module, folder_ / "cut.so");
    for (int part = 15; part > 0; --part) {
        std::filesystem::resize_file(folder_ / "cut.so", size * part / 16);
        const RunResult result = list(folder_.path().string());
        EXPECT_EQ(result.exit_code, 4) << part;
        EXPECT_THAT(result.err, AnyOf(HasSubstr("cut.so': can't be loaded: it is cut short\n"),
                                      HasSubstr("cut.so': no plugin of lxsrender: ")))
            << part;  // what is behind the segments is for debuggers
    }
}

/// To open it would be to wait for whoever writes to it.
TEST_F(PluginModuleTest, FileThatIsAPipe) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe.so").c_str(), 0600), 0);
    const RunResult result = list(folder_.path().string());
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_THAT(result.err, HasSubstr("pipe.so': can't be loaded: it is no regular file\n"));
}

TEST_F(PluginModuleTest, FolderThatIsMissing) {
    const RunResult result = list("/no/such/folder");
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_THAT(result.err,
                HasSubstr("plugin folder '/no/such/folder': No such file or directory"));
}

TEST_F(PluginModuleTest, PathGivenTwiceLoadsOnce) {
    const std::string folder = kTroublesome;
    const RunResult result = run_lxsrender(
        folder_, {"--list-plugins", "--plugin-path", folder, "--plugin-path", folder + "/."});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("sleeper"));
}

// A module under work stands in for the installed one, whose integrators have the same names.
TEST_F(PluginModuleTest, FirstFileOfANameIsTaken) {
    const std::filesystem::path work = folder_.path() / "work";
    std::filesystem::create_directory(work);
    std::filesystem::copy_file(std::filesystem::path(kTroublesome) / "troublesome.so",
                               work / "troublesome.so");
    const RunResult result = run_lxsrender(
        folder_, {"--list-plugins", "--plugin-path", work.string(), "--plugin-path", kTroublesome});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("sleeper"));
}

TEST_F(PluginModuleTest, IntegratorThatCannotBeMade) {
    const RunResult throwing = render("throwing");
    EXPECT_EQ(throwing.exit_code, 4);
    EXPECT_THAT(throwing.err, HasSubstr("creating integrator \"throwing\" failed: no such luck"));
    const RunResult absent = render("absent");
    EXPECT_EQ(absent.exit_code, 4);
    EXPECT_THAT(absent.err, HasSubstr("creating integrator \"absent\" gave none"));
}

// The exception's code lies in the module, which must still be loaded when it is reported.
TEST_F(PluginModuleTest, BadInputThatAModuleFinds) {
    const RunResult result = render("picky");
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.err, HasSubstr("command line: --integrator picky: error: picky: takes no "
                                      "scene of yours"));
}

TEST_F(PluginModuleTest, IntegratorThatRefusesTheScene) {
    const RunResult result = render("refuser");
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.err, HasSubstr("error: scene.lxs: \"refuser\" can't render it: it only "
                                      "renders on Sundays"));
}

}  // namespace
}  // namespace lxs::test::plugin_module_test
