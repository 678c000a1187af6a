// This process's place among those that --mpi renders with. The first rank is the one that users
// see: it alone prints, and writes files; the others help it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "lxs/host/exit_code.h"
#include "lxs/mpi/process_group.h"

namespace lxs {

/// A rank failed, of which the others are told: "process 2 of 3: " and what it said.
class RankFailure : public std::runtime_error {
  public:
    RankFailure(const std::string& what, ExitCode code) : std::runtime_error(what), code_(code) {}
    ExitCode code() const { return code_; }

  private:
    ExitCode code_;
};

/// Ranks go on together: each exchange either has what all tell, or throws RankFailure in all as
/// soon as one of them ends.
class RankJob final : public Ranks {
  public:
    /// What `group` joins; it outlives this. `captured` gives what a rank that helps printed,
    /// should it fail.
    RankJob(ProcessGroup& group, std::function<std::string()> captured);

    std::uint32_t rank() const override { return group_.rank(); }
    std::uint32_t count() const override { return group_.count(); }
    RankMessages exchange(std::span<const std::byte> own) override;

    /// Whether it is not the first.
    bool helps() const { return rank() > 0; }
    /// Throws RankFailure unless all ranks give the same bytes. `what` they stand for, as in "read
    /// another scene".
    void agree(std::span<const std::byte> bytes, const std::string& what);
    /// The first rank says whether another pass follows, the others hear it. After the last the
    /// ranks part.
    bool another_pass(bool follows = false);
    /// Why exchanges have ended, if one of them found that a rank had failed.
    const std::optional<RankFailure>& failure() const { return failure_; }
    RankTraffic traffic() const { return group_.traffic(); }

    /// Before the process ends with `code`: tells the others, unless they know. Returns the code
    /// to end with; prints what another rank failed with, if it is for this one to say.
    ExitCode end(ExitCode code);

  private:
    ProcessGroup& group_;
    std::function<std::string()> captured_;
    bool parted_ = false;  // nothing is exchanged any more
    std::optional<RankFailure> failure_;
};

/// The job that --mpi, among the arguments, asks for; null without it, or where there is no MPI.
/// What ranks print that help goes nowhere from then on. Throws ProcessGroupFailure.
std::unique_ptr<RankJob> join_rank_job(int argc, const char* const* argv);

}  // namespace lxs
