// Messages on standard error, and one live line below them on a terminal; or handed to a program
// that has a log of its own.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "lxs/host/command_line.h"
#include "lxs/sdk/log.h"

namespace spdlog {
class logger;
}

namespace lxs {

/// The verbatim ones say themselves what they are.
enum class MessageKind : std::uint8_t { Debug, Info, Verbatim, Warning, VerbatimError, Error };

/// Takes messages of all kinds; may be called from many threads at once.
using MessageSink = std::function<void(MessageKind, std::string_view)>;

/// May be called from many threads at once.
class ConsoleLog : public Log {
  public:
    explicit ConsoleLog(Verbosity verbosity);
    /// Nothing is printed: `sink` gets the messages.
    explicit ConsoleLog(MessageSink sink);
    ~ConsoleLog() override;

    void info(std::string_view message) override;
    void warning(std::string_view message) override;
    void debug(std::string_view message) override;
    void error(std::string_view message);
    /// A message that says itself what it is: printed as it stands, even with --quiet. `error`:
    /// that it is one.
    void verbatim(std::string_view message, bool error = false);

    /// True if a live line is shown: standard error is a terminal, and --quiet is not given.
    bool live() const { return live_; }
    /// Replaces the live line.
    void show_live(const std::string& line);
    /// Takes the live line away.
    void clear_live();

  private:
    void take(MessageKind kind, std::string_view message);
    void print(MessageKind kind, std::string_view message);
    void erase_live();

    MessageSink sink_;
    std::shared_ptr<spdlog::logger> logger_;  ///< null with a sink
    std::mutex mutex_;
    bool live_;
    std::string line_;
};

}  // namespace lxs
