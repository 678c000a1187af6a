// Reads the main scene file and those it includes.
#pragma once

#include <memory>

#include "arguments.h"

namespace lxs {

/// Content of the file `path`, "-" for standard input. Throws std::system_error.
std::string read_text(const std::string& path);

/// The file that an Include names. Throws InputError if it is missing or can't be read, includes
/// itself, or nests too deep.
std::shared_ptr<const SourceFile> open_include(const Name& file, const std::string& main_directory);

}  // namespace lxs
