// Ranks that go on together, or end together.
#include "lxs/host/rank_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "captured_output.h"

namespace lxs {
namespace {

// Marks of messages.
constexpr std::uint8_t kGoesOn = 0, kEnds = 1;

/// What a rank told as it ended: its exit code, and what it printed.
RankFailure failure_of(std::uint32_t rank, std::uint32_t count, std::span<const std::byte> told) {
    const auto code = static_cast<ExitCode>(std::to_integer<unsigned char>(told[0]));
    std::string text(reinterpret_cast<const char*>(told.data()) + 1, told.size() - 1);
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    if (text.empty()) text = "it ended early";
    return {fmt::format("process {} of {}: {}", rank + 1, count, text), code};
}

}  // namespace

RankJob::RankJob(ProcessGroup& group, std::function<std::string()> captured)
    : group_(group), captured_(std::move(captured)) {}

RankMessages RankJob::exchange(std::span<const std::byte> own) {
    if (failure_) throw *failure_;
    MarkedMessages told = group_.exchange(own, kGoesOn);
    for (std::uint32_t rank = 0; rank < count(); ++rank) {
        if (told.marks[rank] != kEnds) continue;
        parted_ = true;
        throw failure_.emplace(failure_of(rank, count(), told.messages.of(rank)));
    }
    return std::move(told.messages);
}

void RankJob::agree(std::span<const std::byte> bytes, const std::string& what) {
    const RankMessages all = exchange(bytes);
    for (std::uint32_t rank = 1; rank < count(); ++rank) {
        if (std::ranges::equal(all.of(rank), all.of(0))) continue;
        // Not parted: one that is ahead, in an exchange of the engine's, hears of it by end().
        throw failure_.emplace(
            fmt::format("process {} of {} {} than the first: all of them need the same files",
                        rank + 1, count(), what),
            ExitCode::BadInput);
    }
}

bool RankJob::another_pass(bool follows) {
    const std::byte own{static_cast<unsigned char>(follows)};
    const bool goes_on = exchange({&own, 1}).of(0)[0] != std::byte{0};
    parted_ = !goes_on;
    return goes_on;
}

ExitCode RankJob::end(ExitCode code) {
    if (!parted_) {
        std::string own(1, static_cast<char>(code));
        if (helps()) own += captured_();
        const MarkedMessages told = group_.exchange(std::as_bytes(std::span(own)), kEnds);
        // Where all end, the first that failed tells how.
        for (std::uint32_t rank = 0; rank < count() && code == ExitCode::Success; ++rank) {
            if (told.marks[rank] != kEnds) continue;
            const RankFailure other = failure_of(rank, count(), told.messages.of(rank));
            code = other.code();
            if (code != ExitCode::Success && !helps())
                std::fprintf(stderr, "error: %s\n", other.what());
        }
    }
    group_.leave();
    return code;
}

std::unique_ptr<RankJob> join_rank_job(int argc, const char* const* argv) {
    const bool asked = std::any_of(argv, argv + argc,
                                   [](const char* word) { return std::string(word) == "--mpi"; });
    if (!asked || !has_process_group()) return nullptr;
    ProcessGroup& group = process_group();
    if (group.rank() == 0) return std::make_unique<RankJob>(group, [] { return std::string(); });
    return std::make_unique<RankJob>(
        group, [output = std::make_shared<CapturedOutput>()] { return output->text(); });
}

}  // namespace lxs
