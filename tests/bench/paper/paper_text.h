// paper.json of a study as Markdown: a table for each figure of the paper.
#pragma once

#include <string>

#include "study_file.h"

namespace bench {

/// All figures with a heading each, after what the study was run with.
std::string paper_text(const Json& paper);

}  // namespace bench
