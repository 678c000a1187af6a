// Protects the reading of checkpoints that an accident or somebody has changed: a changed byte and
// a missing end are refused and the file stays; and where the checksum was made to fit again,
// nothing worse than a refusal or a wrong image happens: no crash, no hang, no memory beyond the
// file's.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <random>

#include "lxs/host/checkpoint_file.h"
#include "lxsrender_process.h"
#include "resumable_scene.h"
#include "stress_case.h"

namespace stress::hostile_checkpoint_test {
namespace {

using lxs::test::RunResult;
using Options = std::vector<std::string>;

constexpr int kRefused = 6;

class HostileCheckpointTest : public testing::TestWithParam<ResumableRender> {
  protected:
    HostileCheckpointTest() : options_(put_scene(GetParam(), folder_)) {}

    RunResult run(const Options& more) const {
        Options all = options_;
        all.insert(all.end(), {"-o", "out.exr", "--checkpoint", "check", "--passes"});
        all.insert(all.end(), more.begin(), more.end());
        return lxs::test::run_lxsrender(folder_, all);
    }
    /// A checkpoint after four passes, and the most memory that it took to make one.
    std::string make_checkpoint() const {
        const RunResult result = run({"4"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        std::filesystem::remove(folder_ / "out.exr");
        return folder_.read("check");
    }
    std::size_t somewhere(std::size_t size) {
        return std::uniform_int_distribution<std::size_t>(0, size - 1)(random_);
    }

    render::Folder folder_;
    Options options_;
    std::mt19937_64 random_{19411207};
};

/// Resident memory that the hungriest child has had so far, bytes.
std::size_t peak_of_children() {
    rusage usage{};
    ::getrusage(RUSAGE_CHILDREN, &usage);
    return std::size_t(usage.ru_maxrss) * 1024;
}

TEST_P(HostileCheckpointTest, FlippedBytesAndMissingEndsAreRefused) {
    const std::string whole = make_checkpoint();
    const int places = sized(3, 40);
    for (int i = 0; i < places; ++i) {
        std::string damaged = whole;
        damaged[somewhere(whole.size())] ^= static_cast<char>(1 + somewhere(255));
        for (const std::string& file : {damaged, whole.substr(0, somewhere(whole.size()))}) {
            folder_.write("check", file);
            const RunResult result = run({"6", "--resume"});
            EXPECT_EQ(result.exit_code, kRefused) << result.err;
            EXPECT_NE(result.err.find("error: cannot resume from 'check': "), std::string::npos);
            EXPECT_TRUE(folder_.read("check") == file) << "the checkpoint was changed";
            EXPECT_FALSE(folder_.has("out.exr"));
        }
    }
    record(fmt::format("{} flipped bytes and {} truncations of {} bytes", places, places,
                       whole.size()),
           "all refused with exit code 6, file unchanged, nothing rendered");
}

/// Another content under a checksum of its own.
void seal(const render::Folder& folder, std::span<const std::byte> content) {
    std::vector<std::byte> bytes(content.begin(), content.end());
    lxs::CheckpointWriter writer(folder / "check");
    writer.bytes(bytes);
    writer.commit();
}

TEST_P(HostileCheckpointTest, ForgedOnesDoNoHarm) {
    const std::string whole = make_checkpoint();
    const auto content = lxs::checkpoint_content(std::as_bytes(std::span(whole)));
    constexpr std::size_t kFingerprintBytes = 48;  // else it is of another render
    ASSERT_EQ(run({"6", "--resume"}).exit_code, 0);
    const std::size_t honest_peak = peak_of_children();
    const int tries = sized(4, 100);
    int refused = 0;
    for (int i = 0; i < tries; ++i) {
        std::vector<std::byte> forged(content.begin(), content.end());
        // A number of extreme size, mostly where sizes and indices stand: near begin or end.
        const std::uint64_t values[] = {
            0, 1, 0x7fffffff, ~std::uint64_t{0}, std::uint64_t{1} << somewhere(64), random_()};
        const std::uint64_t value = values[somewhere(std::size(values))];
        const std::size_t room = forged.size() - kFingerprintBytes - sizeof value;
        const std::size_t near = std::min<std::size_t>(room, 512);
        const std::size_t at = kFingerprintBytes + (i % 3 == 0   ? somewhere(near)
                                                    : i % 3 == 1 ? room - somewhere(near)
                                                                 : somewhere(room));
        std::memcpy(&forged[at], &value, sizeof value);
        if (i % 8 == 7) forged.resize(kFingerprintBytes + somewhere(room));
        seal(folder_, forged);
        const RunResult result = run({"6", "--resume"});
        EXPECT_TRUE(result.exit_code == 0 || result.exit_code == kRefused)
            << "exit code " << result.exit_code << " with " << value << " at " << at << '\n'
            << result.err;
        if (result.exit_code == kRefused) ++refused;
        if (!folder_.has("out.exr")) continue;
        for (const float v : render::read_image(folder_ / "out.exr").rgb)
            ASSERT_TRUE(std::isfinite(v) && v >= 0) << value << " at " << at;
        std::filesystem::remove(folder_ / "out.exr");
    }
    const double growth = double(peak_of_children()) - double(honest_peak);
    const double bound = 2 * double(whole.size()) + 64e6;
    EXPECT_LT(growth, bound);
    record(fmt::format("{} forged contents of {} bytes", tries, content.size()),
           fmt::format("{} refused, others rendered; {:.1f} MB more memory of at most {:.0f}",
                       refused, growth * 1e-6, bound * 1e-6));
}

INSTANTIATE_TEST_SUITE_P(StressCheckpoint, HostileCheckpointTest, testing::ValuesIn(rich_renders()),
                         [](const auto& given) { return given.param.name; });

}  // namespace
}  // namespace stress::hostile_checkpoint_test
