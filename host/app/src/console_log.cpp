// Messages on standard error, and one live line below them on a terminal.
#include "lxs/host/console_log.h"

#include <spdlog/logger.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <unistd.h>

#include <cstdio>

#include "lxs/sdk/diagnostics.h"

namespace lxs {
namespace {

spdlog::level::level_enum least_level(Verbosity verbosity) {
    switch (verbosity) {
        case Verbosity::Quiet:
            return spdlog::level::warn;
        case Verbosity::Normal:
            return spdlog::level::info;
        case Verbosity::Verbose:
            break;
    }
    return spdlog::level::debug;
}

}  // namespace

ConsoleLog::ConsoleLog(Verbosity verbosity)
    : logger_(std::make_shared<spdlog::logger>("lxsrender",
                                               std::make_shared<spdlog::sinks::stderr_sink_mt>())),
      live_(verbosity != Verbosity::Quiet && ::isatty(STDERR_FILENO) == 1) {
    logger_->set_pattern("%v");
    logger_->set_level(least_level(verbosity));
}

ConsoleLog::~ConsoleLog() {
    clear_live();
}

void ConsoleLog::info(std::string_view message) {
    print(spdlog::level::info, message);
}

void ConsoleLog::warning(std::string_view message) {
    print(spdlog::level::warn, "warning: " + std::string(message));
}

void ConsoleLog::debug(std::string_view message) {
    print(spdlog::level::debug, message);
}

void ConsoleLog::error(std::string_view message) {
    print(spdlog::level::err, "error: " + std::string(message));
}

void ConsoleLog::verbatim(std::string_view message) {
    print(spdlog::level::err, message);
}

void ConsoleLog::print(int level, std::string_view message) {
    const auto spdlog_level = static_cast<spdlog::level::level_enum>(level);
    if (!logger_->should_log(spdlog_level)) return;
    while (!message.empty() && message.back() == '\n')
        message.remove_suffix(1);
    const std::lock_guard lock(mutex_);
    erase_live();
    logger_->log(spdlog_level, "{}", printable(message));
    if (!line_.empty()) std::fputs(line_.c_str(), stderr);
}

void ConsoleLog::erase_live() {
    if (line_.empty()) return;
    constexpr const char* kStartOfLineAndErase = "\r\033[K";
    std::fputs(kStartOfLineAndErase, stderr);
}

void ConsoleLog::show_live(const std::string& line) {
    if (!live_) return;
    const std::lock_guard lock(mutex_);
    erase_live();
    line_ = line;
    std::fputs(line_.c_str(), stderr);
}

void ConsoleLog::clear_live() {
    const std::lock_guard lock(mutex_);
    erase_live();
    line_.clear();
}

}  // namespace lxs
