// Names of files, made to fit the bounds of a file system.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>

namespace lxs {

/// The longest name, in bytes, that a file in `folder` may have; 255 where that is not told.
std::size_t longest_name(const std::filesystem::path& folder);

/// `name`, cut after at most `bytes` bytes and between two UTF-8 characters.
std::string cut_name(std::string name, std::size_t bytes);

/// Where a file that is written to `path` stands: `path`, or where its symbolic links lead, also if
/// nothing is there yet. `error` tells of links that lead in a circle.
std::filesystem::path follow_links(const std::filesystem::path& path, std::error_code& error);

}  // namespace lxs
