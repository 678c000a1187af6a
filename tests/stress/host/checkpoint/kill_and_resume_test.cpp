// Protects renders that are killed without warning: at no moment is an output torn, and resumed
// until it ends the render has the image, and the counts, of one that nobody disturbed.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "left_files.h"
#include "lxsrender_process.h"
#include "resumable_scene.h"
#include "stress_case.h"

namespace stress::kill_and_resume_test {
namespace {

using lxs::test::LxsrenderProcess;
using lxs::test::RunResult;
using Options = std::vector<std::string>;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr int kKilled = 128 + SIGKILL;

/// What a render must have in common with the undisturbed one.
struct Outcome {
    std::string exr, png;
    nlohmann::json counts;
};

class KillAndResumeTest : public testing::TestWithParam<ResumableRender> {
  protected:
    KillAndResumeTest() : options_(put_scene(GetParam(), folder_)) {}

    Options render(const Options& more) const {
        Options all = options_;
        all.insert(all.end(), {"-o", "out.exr", "--stats", "stats.json", "--passes",
                               std::to_string(GetParam().passes)});
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    /// The render that is killed; with one, two or three threads.
    Options resumable(int run) const {
        return render({"--checkpoint", "check", "--checkpoint-interval", "0", "--resume",
                       "--threads", std::to_string(1 + run % 3)});
    }
    Outcome outcome() const {
        const auto statistics = nlohmann::json::parse(folder_.read("stats.json"));
        nlohmann::json counts;
        for (const char* name : {"passes", "samples per pixel", "photon paths", "rays"})
            counts[name] = statistics["counts"][name];
        return {folder_.read("out.exr"), folder_.read("out.png"), counts};
    }
    void remove_outputs() const {
        for (const char* name : kOutputs)
            std::filesystem::remove(folder_ / name);
    }
    /// Waits for a moment to kill at, any in a whole render's life; with `in_writing`, while the
    /// file that is written next is being written.
    void wait_for_a_moment(bool in_writing, double life) {
        std::uniform_real_distribution<double> any(0, life);
        std::this_thread::sleep_for(Seconds(any(random_)));
        if (!in_writing) return;
        const auto end = Clock::now() + Seconds(life / 4);
        const std::string before = folder_state(folder_);
        while (Clock::now() < end && folder_state(folder_) == before)
            std::this_thread::yield();
        std::uniform_real_distribution<double> soon(0, 4e-3);
        std::this_thread::sleep_for(Seconds(soon(random_)));
    }
    void expect_outcome(const Outcome& expected) const {
        const Outcome found = outcome();
        EXPECT_TRUE(found.exr == expected.exr) << "the EXR differs";
        EXPECT_TRUE(found.png == expected.png) << "the PNG differs";
        EXPECT_EQ(found.counts, expected.counts);
    }

    render::Folder folder_;
    Options options_;
    std::mt19937 random_{20140817};
};

TEST_P(KillAndResumeTest, AnyMomentLeavesWholeFilesAndTheSameImage) {
    const RunResult undisturbed = lxs::test::run_lxsrender(folder_, render({}));
    ASSERT_EQ(undisturbed.exit_code, 0) << undisturbed.err;
    const Outcome expected = outcome();
    const auto start = Clock::now();
    ASSERT_EQ(lxs::test::run_lxsrender(folder_, resumable(0)).exit_code, 0);
    const double life = Seconds(Clock::now() - start).count();
    expect_outcome(expected);

    const int wanted = sized(3, 50);
    int kills = 0, in_writing = 0, resumed = 0, completed = 0;
    remove_outputs();
    bool ended = false;
    for (int run = 0; !ended; ++run) {
        LxsrenderProcess process(folder_, resumable(run));
        if (kills < wanted) {
            wait_for_a_moment(run % 2 == 1, life);
            process.send(SIGKILL);
        }
        const RunResult result = process.wait();
        ASSERT_TRUE(result.exit_code == 0 || result.exit_code == kKilled) << result.err;
        if (result.err.find("resumed from") != std::string::npos) ++resumed;
        ASSERT_EQ(torn_outputs(folder_), "") << "after kill " << kills;
        if (result.exit_code == kKilled) {
            ++kills;
            if (!temporary_files(folder_).empty()) ++in_writing;
            continue;
        }
        ++completed;
        expect_outcome(expected);
        EXPECT_EQ(temporary_files(folder_), "");
        ended = kills == wanted;
        if (!ended) remove_outputs();
    }
    record(fmt::format("{} kills with SIGKILL, {} of them while a file was written", kills,
                       in_writing),
           fmt::format("no file torn; {} runs resumed, {} completed, EXR, PNG and counts identical",
                       resumed, completed));
}

INSTANTIATE_TEST_SUITE_P(StressCheckpoint, KillAndResumeTest,
                         testing::ValuesIn(resumable_renders()),
                         [](const auto& given) { return given.param.name; });

}  // namespace
}  // namespace stress::kill_and_resume_test
