// Checkpoints of a render: where they go, when they are written, and how a render goes on from one.
#include "lxs/host/checkpoint.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <new>

#include "lxs/host/checkpoint_file.h"
#include "lxs/host/failure.h"
#include "lxs/host/seconds_since.h"

namespace lxs {
namespace {

namespace fs = std::filesystem;

/// Counts what would be saved.
class StateSize final : public StateArchive {
  public:
    bool restoring() const override { return false; }
    void bytes(std::span<std::byte> data) override { size_ += data.size(); }
    std::size_t remaining() const override { return 0; }
    std::size_t size() const { return size_; }

  private:
    std::size_t size_ = 0;
};

[[noreturn]] void refuse(const std::string& path, const std::string& cause) {
    throw CheckpointFailure(
        fmt::format("cannot resume from '{}': {}; the file is left as it is", path, cause));
}

/// Calls `function`; what is wrong with the checkpoint becomes a CheckpointFailure.
template <class Function>
auto reading(const std::string& path, Function function) {
    try {
        return function();
    } catch (const StateError& error) {
        refuse(path, error.what());
    } catch (const std::bad_alloc&) {
        refuse(path, "there is not enough memory for it");
    }
}

/// All that passes leave for later ones.
void render_state(StateArchive& archive, RenderTotals& totals, RenderSession& session) {
    totals.state(archive);
    session.film->state(archive);
    session.integrator->state(archive);
    // Last: to restore an integrator may take eye paths, which count what they refuse once more.
    session.scene->state(archive);
}

}  // namespace

void check_checkpoint_place(const CommandLine& command, ConsoleLog& log) {
    if (!command.checkpoint) return;
    const std::string& path = *command.checkpoint;
    std::error_code ignored;
    if (!command.resume && fs::exists(path, ignored) && !fs::is_directory(path, ignored)) {
        throw CheckpointFailure(
            fmt::format("'{}' is there already: --resume goes on from it, and a render that does "
                        "not would replace it; remove it to begin anew",
                        path));
    }
    check_writable(path, log);
}

std::optional<FoundCheckpoint> find_checkpoint(const CommandLine& command,
                                               const RenderSession& session, ConsoleLog& log) {
    if (!command.resume) return std::nullopt;
    const std::string& path = *command.checkpoint;
    std::error_code error;
    if (fs::status(path, error).type() == fs::file_type::not_found) {
        log.info(fmt::format("there is no checkpoint '{}' yet: rendering from the start", path));
        return std::nullopt;
    }
    return reading(path, [&] {
        FoundCheckpoint file = read_checkpoint_file(path);
        CheckpointReader reader(checkpoint_content(file));
        Fingerprint fingerprint;
        fingerprint.state(reader);
        const std::string difference = fingerprint.difference(session.fingerprint);
        if (!difference.empty())
            throw StateError("it is of another render, which differs in: " + difference);
        return file;
    });
}

RenderTotals restore(FoundCheckpoint found, const CommandLine& command, RenderSession& session,
                     ConsoleLog& log) {
    RenderTotals totals;
    reading(*command.checkpoint, [&] {
        CheckpointReader reader(checkpoint_content(found));
        Fingerprint fingerprint;
        fingerprint.state(reader);
        render_state(reader, totals, session);
        if (reader.remaining() > 0) throw StateError("there is more in it than was asked for");
    });
    log.info(fmt::format("resumed from '{}' after {} passes", *command.checkpoint, totals.passes));
    if (command.passes && *command.passes < totals.passes) {
        log.warning(
            fmt::format("the checkpoint has {} passes already, more than --passes {}: the "
                        "image is of them all",
                        totals.passes, *command.passes));
    }
    return totals;
}

CheckpointSchedule::CheckpointSchedule(const CommandLine& command, RenderSession& session,
                                       ConsoleLog& log, const RenderTotals& totals)
    : command_(command),
      session_(session),
      log_(log),
      saved_passes_(totals.passes),
      saved_seconds_(totals.seconds) {
    if (!command.checkpoint) return;
    StateSize size;
    RenderTotals counted = totals;
    try {
        render_state(size, counted, session);
    } catch (const std::runtime_error& error) {
        throw CheckpointFailure(fmt::format("\"{}\" can't be saved to '{}': {}",
                                            session.integrator_name, *command.checkpoint,
                                            error.what()));
    }
    log.info(fmt::format("checkpoint '{}' of at least {:.1f} MB, {}", *command.checkpoint,
                         static_cast<double>(size.size()) * 1e-6,
                         command.checkpoint_interval > 0
                             ? fmt::format("every {} s", command.checkpoint_interval)
                             : "after every pass"));
}

void CheckpointSchedule::pass_done(const RenderTotals& totals) {
    if (totals.seconds - saved_seconds_ >= command_.checkpoint_interval) write(totals);
}

void CheckpointSchedule::finish(const RenderTotals& totals) {
    if (totals.passes > saved_passes_) write(totals);
}

void CheckpointSchedule::write(const RenderTotals& totals) {
    if (!command_.checkpoint) return;
    const auto start = std::chrono::steady_clock::now();
    try {
        CheckpointWriter writer(*command_.checkpoint);
        RenderTotals saved = totals;
        session_.fingerprint.state(writer);
        render_state(writer, saved, session_);
        writer.commit();
        saved_passes_ = totals.passes;
    } catch (const std::runtime_error& error) {
        log_.warning(
            fmt::format("no checkpoint after {} passes: {}; the render goes on, an older "
                        "checkpoint stays",
                        totals.passes, error.what()));
    }
    // After a failure too: the next attempt waits for its turn.
    saved_seconds_ = totals.seconds;
    session_.times["checkpoint"] += seconds_since(start);
}

}  // namespace lxs
