// Telling parts of work to other ranks.
//
// A message has the sizes of its parts, the parts, and what was refused: so all threads write it
// and read it, each another part.
#include "ranks/shared_work.h"

#include <cstring>

namespace aips {
namespace {

constexpr const char* kOtherWork = "ranks do not have the same work";

/// Refused light that is new since `before`, by origin; most often none.
void save_invalid(StateArchive& archive, const InvalidSampleFilter& filter,
                  const std::vector<std::uint64_t>& before) {
    const std::vector<std::uint64_t> now = filter.counts();
    std::vector<std::uint64_t> raised;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (now[i] == before[i]) continue;
        raised.push_back(i);
        raised.push_back(now[i] - before[i]);
    }
    archive.values(raised);
}

void add_invalid(StateArchive& archive, InvalidSampleFilter& filter) {
    std::vector<std::uint64_t> raised;
    archive.values(raised);
    for (std::size_t i = 0; i + 1 < raised.size(); i += 2)
        filter.count(static_cast<Origin>(raised[i]), raised[i + 1]);
}

/// Where the parts of a message begin, behind their sizes, and the end of the last.
std::vector<std::size_t> begins_of(const std::vector<std::size_t>& sizes) {
    std::vector<std::size_t> begins{sizes.size() * sizeof(std::size_t)};
    for (const std::size_t size : sizes)
        begins.push_back(begins.back() + size);
    return begins;
}

}  // namespace

SharedWork::SharedWork(Ranks* ranks, std::uint32_t count, InvalidSampleFilter* filter)
    : ranks_(ranks), count_(count), filter_(filter) {
    if (ranks_ && filter_) refused_before_ = filter_->counts();
}

std::span<const std::byte> SharedWork::pack(const PartState& state) {
    const std::uint32_t parts = last() - first();
    std::vector<std::size_t> sizes(parts + 1);
    tbb::parallel_for(0u, parts, [&](std::uint32_t i) {
        RankMeasure measure;
        state(first() + i, measure);
        sizes[i] = measure.size();
    });
    RankMeasure refused;
    if (filter_) save_invalid(refused, *filter_, refused_before_);
    sizes[parts] = refused.size();
    const std::vector<std::size_t> begins = begins_of(sizes);
    message_ = std::make_unique_for_overwrite<std::byte[]>(begins.back());
    const std::span message(message_.get(), begins.back());
    std::memcpy(message.data(), sizes.data(), begins.front());
    const auto place = [&](std::uint32_t i) {
        return RankWriter(message.subspan(begins[i], sizes[i]));
    };
    tbb::parallel_for(0u, parts, [&](std::uint32_t i) {
        RankWriter writer = place(i);
        state(first() + i, writer);
        StateArchive::check(writer.remaining() == 0, "a part shrank while it was told");
    });
    RankWriter writer = place(parts);
    if (filter_) save_invalid(writer, *filter_, refused_before_);
    return message;
}

void SharedWork::unpack(std::uint32_t other, std::span<const std::byte> message,
                        const PartState& state) {
    const std::uint32_t first = first_of(other), parts = first_of(other + 1) - first;
    std::vector<std::size_t> sizes(parts + 1);
    RankReader head(message);
    plain(head, std::span(sizes));
    const std::vector<std::size_t> begins = begins_of(sizes);
    StateArchive::check(begins.back() == message.size(), kOtherWork);
    const auto place = [&](std::uint32_t i) {
        return RankReader(message.subspan(begins[i], sizes[i]));
    };
    tbb::parallel_for(0u, parts, [&](std::uint32_t i) {
        RankReader reader = place(i);
        state(first + i, reader);
        StateArchive::check(reader.remaining() == 0, kOtherWork);
    });
    RankReader reader = place(parts);
    if (filter_) add_invalid(reader, *filter_);
    StateArchive::check(reader.remaining() == 0, kOtherWork);
}

void SharedWork::exchange(const PartState& state) {
    if (!ranks_) return;
    const RankMessages messages = ranks_->exchange(pack(state));
    message_.reset();
    for (std::uint32_t other = 0; other < ranks_->count(); ++other) {
        if (other != ranks_->rank()) unpack(other, messages.of(other), state);
    }
}

}  // namespace aips
