// For looks ahead, whose findings are told when their turn comes.
#pragma once

#include "lxs/sdk/diagnostics.h"

namespace lxs {

class NoMessages final : public Diagnostics {
  public:
    void warning(const SourceLocation& /*where*/, const std::string& /*message*/) override {}
    void unknown_parameter(const SourceLocation& /*where*/,
                           const std::string& /*message*/) override {}
};

}  // namespace lxs
