// OpenEXR files in memory.
#pragma once

#include <cstddef>
#include <vector>

#include "lxs/imaging/file_layers.h"

namespace lxs {

/// The bytes of a scan-line EXR (32-bit float, ZIP) with the frame's window as data window. Throws
/// std::exception when OpenEXR refuses a name.
std::vector<std::byte> encode_exr(const FileLayers& layers);

}  // namespace lxs
