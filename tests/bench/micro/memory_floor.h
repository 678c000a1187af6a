// The floor of what moves memory: the bytes it must touch over the speed of a plain copy.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>

namespace aips::bench {

/// Bytes read and written per second of processor time by one thread's memcpy of more than the
/// caches hold; measured once.
double copy_bytes_per_second();

/// Adds `bytes_per_second`, and `floor_ns`: what a copy would take for as many bytes, to be held
/// against the column CPU, which may lie below it where caches hold what is touched.
void report_bytes(benchmark::State& state, std::size_t bytes_per_iteration);

}  // namespace aips::bench
