// The processes of an MPI job. MPI itself is in a module of its own, which is loaded when it is
// asked for: nothing else is built with it.
#pragma once

#include <stdexcept>

#include "lxs/sdk/ranks.h"

namespace lxs {

/// What exchanges took so far.
struct RankTraffic {
    std::uint64_t exchanges = 0;
    std::uint64_t told_bytes = 0;   ///< by this rank
    std::uint64_t heard_bytes = 0;  ///< by this rank from the others
    double waiting_seconds = 0;     ///< until all ranks had come
    double transfer_seconds = 0;    ///< from then on
};

/// What all ranks told, and as what.
struct MarkedMessages {
    RankMessages messages;
    std::vector<std::uint8_t> marks;  ///< [rank]
};

/// The ranks of a job.
class ProcessGroup {
  public:
    virtual ~ProcessGroup() = default;
    virtual std::uint32_t rank() const = 0;
    virtual std::uint32_t count() const = 0;
    /// As Ranks::exchange(); each message has a mark.
    virtual MarkedMessages exchange(std::span<const std::byte> own, std::uint8_t mark) = 0;
    virtual RankTraffic traffic() const = 0;
    /// Ends this process's part of the job; nothing is exchanged after it.
    virtual void leave() = 0;
};

/// The module with MPI can't be loaded.
class ProcessGroupFailure : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Whether this installation has MPI.
bool has_process_group();
/// The job that this process is part of: alone, if it was not started by mpirun. Call it once.
/// Throws ProcessGroupFailure.
ProcessGroup& process_group();

}  // namespace lxs
