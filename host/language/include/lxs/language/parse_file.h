// Parses the text of one file into statements.
#pragma once

#include <functional>
#include <memory>

#include "lxs/language/statement.h"

namespace lxs {

using StatementHandler = std::function<void(Statement&)>;

/// Calls `handler` with each statement of `file`, in order. Throws InputError on bad syntax.
void parse_file(const std::shared_ptr<const SourceFile>& file, const StatementHandler& handler);

}  // namespace lxs
