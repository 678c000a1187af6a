// Protects lxsmerge as a user meets it: real renders, exit codes and messages.
#include "lxs/merge/merge_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lxs/imaging/exr_image.h"
#include "lxsrender_process.h"

namespace lxs::merge_command_test {
namespace {

using testing::HasSubstr;

class LxsMerge : public testing::Test {
  protected:
    void render(const std::string& name, const std::string& seed, const std::string& passes) {
        const test::RunResult result = test::run_lxsrender(
            folder_,
            {"-", "--seed", seed, "--passes", passes, "-o", name, "--stats", name + ".json"},
            test::small_scene());
        ASSERT_EQ(result.exit_code, 0) << result.err;
    }

    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

    /// Standard error is told in `said_`.
    ExitCode merge(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "lxsmerge");
        std::vector<const char*> argv;
        for (const std::string& argument : arguments)
            argv.push_back(argument.c_str());
        testing::internal::CaptureStderr();
        const ExitCode code = run_lxsmerge(int(argv.size()), argv.data());
        said_ = testing::internal::GetCapturedStderr();
        return code;
    }

    test::TemporaryFolder folder_;
    std::string said_;
};

TEST_F(LxsMerge, JoinsRendersOfOneScene) {
    render("a.exr", "1", "4");
    render("b.exr", "2", "12");
    ASSERT_EQ(merge({path("a.exr"), path("b.exr"), "-o", path("c.exr"), "--stats", path("c.json")}),
              ExitCode::Success)
        << said_;
    EXPECT_THAT(said_, HasSubstr("2 images of 16 samples per pixel together, estimated error"));
    const ExrImage a = read_exr(path("a.exr")), b = read_exr(path("b.exr")),
                   c = read_exr(path("c.exr"));
    const std::vector<float>& merged = c.channels.at("G");
    for (std::size_t i = 0; i < merged.size(); ++i) {
        EXPECT_NEAR(merged[i], (a.channels.at("G")[i] + 3 * b.channels.at("G")[i]) / 4,
                    1e-6f * (1 + merged[i]));
    }
    const auto json = nlohmann::json::parse(std::ifstream(path("c.json")));
    EXPECT_EQ(json["seeds"], (std::vector<int>{1, 2}));
    EXPECT_EQ(json["counts"]["passes"], 16);
    EXPECT_TRUE(json["estimated error"].contains("relmse"));
}

TEST_F(LxsMerge, SumsStatisticsUp) {
    const auto read = [&](const std::string& name) {
        return nlohmann::json::parse(std::ifstream(path(name)));
    };
    render("a.exr", "1", "4");
    render("b.exr", "2", "12");
    render("d.exr", "3", "8");
    ASSERT_EQ(merge({path("a.exr"), path("b.exr"), "-o", path("c.exr"), "--stats", path("c.json"),
                     "--stats-of", path("a.exr.json"), path("b.exr.json")}),
              ExitCode::Success)
        << said_;
    const auto a = read("a.exr.json"), b = read("b.exr.json"), both = read("c.json")["renders"];
    EXPECT_EQ(both["seeds"], (std::vector<int>{1, 2}));
    for (const char* count : {"passes", "samples per pixel", "rays", "photon paths"})
        EXPECT_EQ(both["counts"][count],
                  a["counts"][count].get<double>() + b["counts"][count].get<double>());
    EXPECT_DOUBLE_EQ(both["render CPU seconds"].get<double>(),
                     a["render CPU seconds"].get<double>() + b["render CPU seconds"].get<double>());
    // What is merged may be merged again.
    ASSERT_EQ(merge({path("c.exr"), path("d.exr"), "-o", path("e.exr"), "--stats", path("e.json"),
                     "--stats-of", path("c.json"), path("d.exr.json")}),
              ExitCode::Success)
        << said_;
    const auto all = read("e.json")["renders"];
    EXPECT_EQ(all["seeds"], (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(all["counts"]["passes"], 24);
}

TEST_F(LxsMerge, StatisticsThatDoNotBelong) {
    render("a.exr", "1", "2");
    render("b.exr", "2", "2");
    render("c.exr", "3", "2");
    std::ofstream(path("other.json")) << R"({"seeds": [1], "counts": {}})";
    const auto refused = [&](std::vector<std::string> files, const char* why) {
        std::vector<std::string> words{path("a.exr"), path("b.exr"),  "-o",        path("o.exr"),
                                       "--stats",     path("o.json"), "--stats-of"};
        for (const std::string& file : files)
            words.push_back(path(file));
        EXPECT_EQ(merge(words), ExitCode::BadInput);
        EXPECT_THAT(said_, HasSubstr(why));
        EXPECT_FALSE(std::ifstream(path("o.exr")));
    };
    refused({"a.exr.json", "none.json"}, "cannot read");
    refused({"a.exr.json", "a.exr"}, "is no statistics file");
    refused({"other.json"}, "is no statistics file");
    refused({"c.exr.json"}, "is of seed 3, which none of the images holds");
    refused({"a.exr.json", "a.exr.json"}, "are both of seed 1");
    EXPECT_EQ(merge({path("a.exr"), path("b.exr"), "-o", path("o.exr"), "--stats-of",
                     path("a.exr.json")}),
              ExitCode::Usage);
}

TEST_F(LxsMerge, NothingThatIsReadIsWritten) {
    render("a.exr", "1", "4");
    render("b.exr", "2", "4");
    std::filesystem::create_hard_link(path("b.exr"), path("twin.exr"));
    std::filesystem::create_symlink("loop.exr", path("loop.exr"));
    const std::string a = folder_.read("a.exr"), b = folder_.read("b.exr"),
                      json = folder_.read("a.exr.json");
    const auto refused = [&](std::vector<std::string> more, const std::string& why) {
        std::vector<std::string> words{path("a.exr"), path("b.exr")};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(merge(words), ExitCode::OutputFailure);
        EXPECT_THAT(said_, HasSubstr("error: cannot write " + why));
        EXPECT_EQ(folder_.read("a.exr"), a);
        EXPECT_EQ(folder_.read("b.exr"), b);
        EXPECT_EQ(folder_.read("a.exr.json"), json);
    };
    refused({"-o", path("a.exr")}, "the image to '" + path("a.exr") +
                                       "': it is the same file as "
                                       "the image to merge '" +
                                       path("a.exr") + "'");
    refused({"-o", path("twin.exr")}, "the image to ");
    refused({"-o", path("c.exr"), "--stats", path("./c.exr")},
            "the statistics to '" + path("./c.exr") + "': it is the same file as the image");
    refused({"-o", path("c.exr"), "--stats", path("b.exr")}, "the statistics to ");
    refused({"-o", path("c.exr"), "--stats", path("a.exr.json"), "--stats-of", path("a.exr.json"),
             path("b.exr.json")},
            "the statistics to '" + path("a.exr.json") +
                "': it is the same file as the "
                "statistics to sum up");
    refused({"-o", path(std::string(300, 'x') + ".exr")}, "'" + path(std::string(300, 'x')));
    refused({"-o", path("loop.exr")}, "'" + path("loop.exr") + "': Too many levels");
    EXPECT_FALSE(folder_.has("c.exr"));
}

TEST_F(LxsMerge, RefusesTheSamePathsTwice) {
    render("a.exr", "1", "4");
    render("b.exr", "1", "12");
    EXPECT_EQ(merge({path("a.exr"), path("b.exr"), "-o", path("c.exr")}), ExitCode::BadInput);
    EXPECT_THAT(said_, HasSubstr("both hold seed 1"));
    EXPECT_FALSE(std::ifstream(path("c.exr")));
}

TEST_F(LxsMerge, SaysWhatIsWrong) {
    render("a.exr", "1", "2");
    EXPECT_EQ(merge({path("a.exr"), path("none.exr"), "-o", path("c.exr")}), ExitCode::BadInput);
    EXPECT_THAT(said_, HasSubstr("No such file or directory"));
    EXPECT_EQ(merge({path("a.exr"), "-o", path("c.exr")}), ExitCode::Usage);
    EXPECT_EQ(merge({path("a.exr"), path("a.exr"), "-o", path("c.png")}), ExitCode::Usage);
    EXPECT_EQ(merge({path("a.exr"), path("a.exr"), "-o", "c.exr", "--stat", "c.json"}),
              ExitCode::Usage);
    EXPECT_THAT(said_, HasSubstr("did you mean --stats?"));
    EXPECT_EQ(merge({path("a.exr"), path("a.exr"), "-o", path("no/c.exr")}),
              ExitCode::OutputFailure);
}

}  // namespace
}  // namespace lxs::merge_command_test
