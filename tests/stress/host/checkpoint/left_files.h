// What a killed render has left in its folder.
#pragma once

#include <string>

#include "temporary_folder.h"

namespace stress {

/// The outputs of a render that runs with `-o out.exr --stats stats.json --checkpoint check`.
inline constexpr const char* kOutputs[] = {"out.exr", "out.png", "stats.json", "check"};

/// What is torn: reads every output that is there to its end. Empty if all are whole.
std::string torn_outputs(const files::TemporaryFolder& folder);

/// Names, sizes and times of all files: differs as soon as one is begun, or written in its place.
std::string folder_state(const files::TemporaryFolder& folder);

/// Names of the temporary files beside the outputs: what was being written.
std::string temporary_files(const files::TemporaryFolder& folder);

}  // namespace stress
