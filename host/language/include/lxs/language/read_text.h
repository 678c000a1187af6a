// The text of scene files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lxs {

/// Content of the file `path`, "-" for standard input. Throws std::system_error.
std::string read_text(const std::string& path);

/// The first word of a scene; empty if it begins with none, but null if there is nothing but
/// comments.
std::optional<std::string_view> first_word(std::string_view scene);

}  // namespace lxs
