// What a render learned, kept in a file for others.
#include "lxs/host/learned_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <new>

#include "lxs/host/checkpoint_file.h"
#include "lxs/host/failure.h"

namespace lxs {
namespace {

namespace fs = std::filesystem;

/// Takes what would be saved, and keeps nothing.
class NoArchive final : public StateArchive {
  public:
    bool restoring() const override { return false; }
    void bytes(std::span<std::byte> /*data*/) override {}
    std::size_t remaining() const override { return 0; }
};

[[noreturn]] void refuse_learned(const std::string& path, const std::string& cause) {
    throw LearnedFailure(fmt::format("cannot begin with '{}': {}", path, cause));
}

/// Calls `function`; what is wrong with the file becomes a LearnedFailure.
template <class Function>
auto reading_learned(const std::string& path, Function function) {
    try {
        return function();
    } catch (const StateError& error) {
        refuse_learned(path, error.what());
    } catch (const std::bad_alloc&) {
        refuse_learned(path, "there is not enough memory for it");
    }
}

/// Fit for a message: what a file holds may be anything.
bool is_name(const std::string& text) {
    constexpr std::size_t kLongest = 64;
    return !text.empty() && text.size() <= kLongest && std::ranges::all_of(text, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-';
    });
}

}  // namespace

void check_learned_place(const CommandLine& command, ConsoleLog& log) {
    if (command.learned_out) check_writable(*command.learned_out, log);
}

std::optional<LearnedFile> read_learned(const CommandLine& command) {
    if (!command.learned_in) return std::nullopt;
    return reading_learned(*command.learned_in, [&] {
        LearnedFile file = read_checkpoint_file(*command.learned_in, kLearnedFormat);
        (void)checkpoint_content(file, kLearnedFormat);
        return std::optional(std::move(file));
    });
}

void take_learned(const LearnedFile& file, const CommandLine& command, RenderSession& session,
                  ConsoleLog& log) {
    reading_learned(*command.learned_in, [&] {
        CheckpointReader reader(checkpoint_content(file, kLearnedFormat));
        std::string integrator;
        std::uint64_t seed = 0;
        reader.text(integrator);
        reader.value(seed);
        if (!is_name(integrator)) throw StateError("it does not say which integrator learned it");
        if (integrator != session.integrator_name) {
            throw StateError(fmt::format("\"{}\" learned it, and this render is by \"{}\"",
                                         integrator, session.integrator_name));
        }
        // What it knows would come from the very numbers that it decides on: a bias.
        if (seed == session.seed) {
            throw StateError(
                fmt::format("it was learned with this render's own random numbers, "
                            "seed {}; give another one with --seed or "
                            "--seed-per-frame",
                            seed));
        }
        try {
            session.integrator->learned(reader);
        } catch (const StateError&) {
            throw;
        } catch (const std::runtime_error& error) {
            throw StateError(error.what());
        }
        if (reader.remaining() > 0) throw StateError("there is more in it than was asked for");
    });
    log.info(fmt::format("beginning with what was learned in '{}'", *command.learned_in));
}

void check_learns(const CommandLine& command, RenderSession& session) {
    if (!command.learned_out) return;
    try {
        NoArchive nowhere;
        session.integrator->learned(nowhere);
    } catch (const std::runtime_error& error) {
        throw LearnedFailure(fmt::format("\"{}\" has nothing for '{}': {}", session.integrator_name,
                                         *command.learned_out, error.what()));
    }
}

bool write_learned(const CommandLine& command, RenderSession& session, ConsoleLog& log) {
    if (!command.learned_out) return true;
    try {
        CheckpointWriter writer(*command.learned_out, kLearnedFormat);
        std::string integrator = session.integrator_name;
        writer.text(integrator);
        writer.value(session.seed);
        session.integrator->learned(writer);
        writer.commit();
    } catch (const PluginFailure&) {
        throw;
    } catch (const std::runtime_error& error) {
        log.error(fmt::format("what was learned is not kept: {}", error.what()));
        return false;
    }
    log.info(fmt::format("wrote what was learned to '{}'", *command.learned_out));
    return true;
}

}  // namespace lxs
