// Warnings about the scene's text, on the log; errors with --strict.
#pragma once

#include <cstdint>

#include "lxs/host/console_log.h"
#include "lxs/sdk/diagnostics.h"

namespace lxs {

class InputDiagnostics : public Diagnostics {
  public:
    InputDiagnostics(ConsoleLog& log, bool strict) : log_(log), strict_(strict) {}

    void warning(const SourceLocation& where, const std::string& message) override;
    /// A warning; with --strict throws InputError.
    void unknown_parameter(const SourceLocation& where, const std::string& message) override;
    std::uint64_t warnings() const { return warnings_; }

  private:
    ConsoleLog& log_;
    bool strict_;
    std::uint64_t warnings_ = 0;
};

}  // namespace lxs
