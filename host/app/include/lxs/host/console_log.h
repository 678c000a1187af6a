// Messages on standard error, and one live line below them on a terminal.
#pragma once

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

/// May be called from many threads at once.
class ConsoleLog : public Log {
  public:
    explicit ConsoleLog(Verbosity verbosity);
    ~ConsoleLog() override;

    void info(std::string_view message) override;
    void warning(std::string_view message) override;
    void debug(std::string_view message) override;
    void error(std::string_view message);
    /// A message that says itself what it is: printed as it stands, even with --quiet.
    void verbatim(std::string_view message);

    /// True if a live line is shown: standard error is a terminal, and --quiet is not given.
    bool live() const { return live_; }
    /// Replaces the live line.
    void show_live(const std::string& line);
    /// Takes the live line away.
    void clear_live();

  private:
    void print(int level, std::string_view message);
    void erase_live();

    std::shared_ptr<spdlog::logger> logger_;
    std::mutex mutex_;
    bool live_;
    std::string line_;
};

}  // namespace lxs
