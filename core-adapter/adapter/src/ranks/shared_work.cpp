// Telling parts of work to other ranks.
#include "ranks/shared_work.h"

namespace aips {
namespace {

/// Refused light that is new since `before`, by origin; most often none.
void save_refused(StateArchive& archive, const Refusals& refusals,
                  const std::vector<std::uint64_t>& before) {
    const std::vector<std::uint64_t> now = refusals.counts();
    std::vector<std::uint64_t> raised;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (now[i] == before[i]) continue;
        raised.push_back(i);
        raised.push_back(now[i] - before[i]);
    }
    archive.values(raised);
}

void add_refused(StateArchive& archive, Refusals& refusals) {
    std::vector<std::uint64_t> raised;
    archive.values(raised);
    for (std::size_t i = 0; i + 1 < raised.size(); i += 2)
        refusals.count(static_cast<Origin>(raised[i]), raised[i + 1]);
}

}  // namespace

SharedWork::SharedWork(Ranks* ranks, std::uint32_t count, Refusals* refusals)
    : ranks_(ranks), count_(count), refusals_(refusals) {
    if (ranks_ && refusals_) refused_before_ = refusals_->counts();
}

void SharedWork::exchange(const std::function<void(std::uint32_t, StateArchive&)>& state) {
    if (!ranks_) return;
    RankWriter writer;
    for (std::uint32_t part = first(); part < last(); ++part)
        state(part, writer);
    if (refusals_) save_refused(writer, *refusals_, refused_before_);
    const RankMessages messages = ranks_->exchange(writer.message());
    for (std::uint32_t other = 0; other < ranks_->count(); ++other) {
        if (other == ranks_->rank()) continue;
        RankReader reader(messages.of(other));
        for (std::uint32_t part = first_of(other); part < first_of(other + 1); ++part)
            state(part, reader);
        if (refusals_) add_refused(reader, *refusals_);
        StateArchive::check(reader.remaining() == 0, "ranks do not have the same work");
    }
}

}  // namespace aips
