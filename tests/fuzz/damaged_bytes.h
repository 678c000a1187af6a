// Bytes of something whole, damaged as a fuzzer likes.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "input_bytes.h"

namespace fuzz {

/// A copy of `whole` with the edits that are left in `input`: bytes and numbers replaced, inserted,
/// removed, moved, the end cut off. The corpus holds edits, so that it stays good whatever becomes
/// of the format; an empty input leaves `whole` as it is. At most 64 KB longer than `whole`.
std::vector<std::byte> damaged_bytes(std::span<const std::byte> whole, InputBytes& input);

}  // namespace fuzz
