// The text of scene files.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lxs/sdk/diagnostics.h"

namespace lxs {

/// Content of the file `path`, "-" for standard input. Throws std::system_error.
std::string read_text(const std::string& path);

/// A main file of this text, as messages show it by `name`.
std::shared_ptr<const SourceFile> source_of(std::string text, std::string name);

/// The first word of a scene; empty if it begins with none, but null if there is nothing but
/// comments.
std::optional<std::string_view> first_word(std::string_view scene);

}  // namespace lxs
