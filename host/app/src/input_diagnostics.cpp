// Warnings about the scene's text, on the log; errors with --strict.
#include "lxs/host/input_diagnostics.h"

namespace lxs {

void InputDiagnostics::warning(const SourceLocation& where, const std::string& message) {
    ++warnings_;
    log_.verbatim(format_message(where, "warning", message));
}

void InputDiagnostics::unknown_parameter(const SourceLocation& where, const std::string& message) {
    if (strict_) throw InputError(where, message);
    warning(where, message);
}

}  // namespace lxs
