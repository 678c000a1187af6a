// `aips-bench agreement`: its findings as Markdown.
#pragma once

#include <string>

#include "study_file.h"

namespace bench {

/// One table for each scene of an agreement.json.
std::string agreement_table(const Json& document);

}  // namespace bench
