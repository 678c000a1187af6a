// The engine's bound of memory against the machine's.
#include "memory_check.h"

#include <unistd.h>

#include <stdexcept>
#include <string>

namespace aips::shim {

void check_memory(std::size_t bound_bytes) {
    const long pages = ::sysconf(_SC_PHYS_PAGES), page_bytes = ::sysconf(_SC_PAGESIZE);
    if (pages <= 0 || page_bytes <= 0) return;
    const std::size_t machine =
        static_cast<std::size_t>(pages) * static_cast<std::size_t>(page_bytes);
    if (bound_bytes / 2 <= machine) return;
    throw std::runtime_error(
        "its settings may take " + std::to_string(bound_bytes >> 20) + " MiB, this machine has " +
        std::to_string(machine >> 20) +
        ": lessen hitpointperpass, iterationphotons, maxnodes, cdfresolution or the image");
}

}  // namespace aips::shim
