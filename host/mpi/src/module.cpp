// The ranks of an MPI job, by MPI. What is an error to MPI ends the whole job, with its message.
#include <mpi.h>

#include <algorithm>
#include <limits>

#include "lxs/mpi/process_group.h"

namespace lxs {
namespace {

/// Bytes of one broadcast: counts of MPI are ints.
constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;

class MpiGroup final : public ProcessGroup {
  public:
    MpiGroup() {
        // Passes may be rendered by another thread than this one, but by one at a time.
        int provided = 0;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &count_);
    }

    std::uint32_t rank() const override { return static_cast<std::uint32_t>(rank_); }
    std::uint32_t count() const override { return static_cast<std::uint32_t>(count_); }
    RankTraffic traffic() const override { return traffic_; }
    void leave() override { MPI_Finalize(); }

    MarkedMessages exchange(std::span<const std::byte> own, std::uint8_t mark) override {
        const double start = MPI_Wtime();
        // Sizes have room for the marks: no memory has 2^56 bytes.
        const std::vector<std::uint64_t> heads = all_of(std::uint64_t{own.size()} << 8 | mark);
        const double all_here = MPI_Wtime();
        MarkedMessages all;
        RankMessages& messages = all.messages;
        messages.begins.push_back(0);
        for (const std::uint64_t head : heads) {
            all.marks.push_back(static_cast<std::uint8_t>(head));
            messages.begins.push_back(messages.begins.back() + (head >> 8));
        }
        const std::size_t size = messages.begins.back();
        const auto bytes = std::make_shared_for_overwrite<std::byte[]>(size);
        messages.bytes = bytes;
        if (size <= std::size_t{std::numeric_limits<int>::max()}) {
            gather(own, messages, bytes.get());
        } else {
            broadcast_each(own, messages.begins, bytes.get());
        }
        ++traffic_.exchanges;
        traffic_.told_bytes += own.size();
        traffic_.heard_bytes += size - own.size();
        traffic_.waiting_seconds += all_here - start;
        traffic_.transfer_seconds += MPI_Wtime() - all_here;
        return all;
    }

  private:
    std::vector<std::uint64_t> all_of(std::uint64_t own) const {
        std::vector<std::uint64_t> all(count());
        MPI_Allgather(&own, 1, MPI_UINT64_T, all.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
        return all;
    }

    void gather(std::span<const std::byte> own, const RankMessages& messages,
                std::byte* bytes) const {
        std::vector<int> sizes, begins;
        for (std::uint32_t r = 0; r < count(); ++r) {
            begins.push_back(static_cast<int>(messages.begins[r]));
            sizes.push_back(static_cast<int>(messages.of(r).size()));
        }
        MPI_Allgatherv(own.data(), static_cast<int>(own.size()), MPI_BYTE, bytes, sizes.data(),
                       begins.data(), MPI_BYTE, MPI_COMM_WORLD);
    }

    void broadcast_each(std::span<const std::byte> own, const std::vector<std::size_t>& begins,
                        std::byte* bytes) const {
        std::ranges::copy(own, bytes + begins[rank()]);
        for (int r = 0; r < count_; ++r) {
            const std::size_t end = begins[static_cast<std::size_t>(r) + 1];
            for (std::size_t at = begins[static_cast<std::size_t>(r)]; at < end;
                 at += kMostAtOnce) {
                MPI_Bcast(bytes + at, static_cast<int>(std::min(kMostAtOnce, end - at)), MPI_BYTE,
                          r, MPI_COMM_WORLD);
            }
        }
    }

    int rank_ = 0, count_ = 1;
    RankTraffic traffic_;
};

}  // namespace
}  // namespace lxs

/// What process_group.cpp looks for.
extern "C" __attribute__((visibility("default"))) lxs::ProcessGroup* lxs_process_group() {
    static lxs::MpiGroup group;
    return &group;
}
