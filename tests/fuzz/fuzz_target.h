// What a fuzz target is: one function that reads its input as a user's and must come back from it.
// libFuzzer calls it on inputs that it makes up; the replayer (replay.cpp) on those of the
// repository. Bounds of time, memory and length stand in options.json (docs/build-on/testing.md).
#pragma once

#include <cstddef>
#include <cstdint>

/// Returns 0 for input that was read as well as for input that was refused with an InputError
/// (or the host's failures of its kind) that says something. Whatever else is thrown ends the
/// process: that is a finding, as is each complaint of a sanitizer.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
