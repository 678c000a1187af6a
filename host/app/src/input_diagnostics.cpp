// Warnings about the scene's text, on the log; errors with --strict.
#include "lxs/host/input_diagnostics.h"

namespace lxs {

namespace {

constexpr std::uint64_t kMostShown = 100;

}  // namespace

void InputDiagnostics::warning(const SourceLocation& where, const std::string& message) {
    ++warnings_;
    if (warnings_ > kMostShown + 1) return;
    if (warnings_ > kMostShown) {
        log_.warning("more than 100 warnings about the scene: no further one is shown");
        return;
    }
    log_.verbatim(format_message(where, "warning", message));
}

void InputDiagnostics::unknown_parameter(const SourceLocation& where, const std::string& message) {
    if (strict_) throw InputError(where, message);
    warning(where, message);
}

}  // namespace lxs
