// Is every radius that a study compares at least four times that of its references?
#pragma once

#include <string>
#include <vector>

#include "study_file.h"

namespace bench {

/// One sentence for each scene whose references have a radius that is more than a quarter of the
/// smallest one reached by a run: there the references' own bias may count as the methods' error.
std::vector<std::string> radius_warnings(const Json& summary);

}  // namespace bench
