// Passes each warning on once, however often the scene gives rise to it.
#pragma once

#include <set>
#include <string>

#include "lxs/sdk/diagnostics.h"

namespace lxs {

/// Exporters repeat themselves: one warning at the first place says as much as a thousand.
class OnceDiagnostics final : public Diagnostics {
  public:
    explicit OnceDiagnostics(Diagnostics& next) : next_(next) {}
    void warning(const SourceLocation& where, const std::string& message) override {
        if (seen_.insert(message).second) next_.warning(where, message);
    }
    void unknown_parameter(const SourceLocation& where, const std::string& message) override {
        if (seen_.insert(message).second) next_.unknown_parameter(where, message);
    }

  private:
    Diagnostics& next_;
    std::set<std::string> seen_;
};

}  // namespace lxs
