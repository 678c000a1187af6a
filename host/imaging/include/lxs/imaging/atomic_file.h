// Writes whole files so that a reader never sees a half-written one.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace lxs {

/// Writes `bytes` to a temporary file beside `path`, flushes it to the device and renames it to
/// `path`; a symbolic link is followed, and a device or pipe is written in place. Throws
/// std::runtime_error with the path and the system's reason; the temporary file is then gone and an
/// older file at `path` untouched.
void write_file_atomically(const std::string& path, std::span<const std::byte> bytes);

}  // namespace lxs
