// What this process uses of the machine.
#pragma once

#include <cstdint>

namespace lxs {

double cpu_seconds();            ///< user and system time of all threads so far
std::uint64_t resident_bytes();  ///< memory in use now; 0 where the system doesn't tell
std::uint64_t peak_resident_bytes();

}  // namespace lxs
