// Messages on standard error, and one live line below them on a terminal; or handed on.
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

spdlog::level::level_enum level_of(MessageKind kind) {
    switch (kind) {
        case MessageKind::Debug:
            return spdlog::level::debug;
        case MessageKind::Info:
            return spdlog::level::info;
        case MessageKind::Warning:
            return spdlog::level::warn;
        case MessageKind::Verbatim:
        case MessageKind::VerbatimError:
        case MessageKind::Error:
            break;
    }
    return spdlog::level::err;
}

std::string prefix_of(MessageKind kind) {
    if (kind == MessageKind::Warning) return "warning: ";
    return kind == MessageKind::Error ? "error: " : "";
}

}  // namespace

ConsoleLog::ConsoleLog(Verbosity verbosity)
    : logger_(std::make_shared<spdlog::logger>("lxsrender",
                                               std::make_shared<spdlog::sinks::stderr_sink_mt>())),
      live_(verbosity != Verbosity::Quiet && ::isatty(STDERR_FILENO) == 1) {
    logger_->set_pattern("%v");
    logger_->set_level(least_level(verbosity));
}

ConsoleLog::ConsoleLog(MessageSink sink) : sink_(std::move(sink)), live_(false) {}

ConsoleLog::~ConsoleLog() {
    clear_live();
}

void ConsoleLog::info(std::string_view message) {
    take(MessageKind::Info, message);
}

void ConsoleLog::warning(std::string_view message) {
    take(MessageKind::Warning, message);
}

void ConsoleLog::debug(std::string_view message) {
    take(MessageKind::Debug, message);
}

void ConsoleLog::error(std::string_view message) {
    take(MessageKind::Error, message);
}

void ConsoleLog::verbatim(std::string_view message, bool error) {
    take(error ? MessageKind::VerbatimError : MessageKind::Verbatim, message);
}

void ConsoleLog::take(MessageKind kind, std::string_view message) {
    while (!message.empty() && message.back() == '\n')
        message.remove_suffix(1);
    if (sink_) {
        sink_(kind, printable(message));
    } else {
        print(kind, message);
    }
}

void ConsoleLog::print(MessageKind kind, std::string_view message) {
    const auto level = level_of(kind);
    if (!logger_->should_log(level)) return;
    const std::lock_guard lock(mutex_);
    erase_live();
    logger_->log(level, "{}{}", prefix_of(kind), printable(message));
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
