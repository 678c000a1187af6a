// Which passes shoot photons: all, or one of several where photons bring little.
//
// A pass that shoots has costs that do not fall with its photons: points in reach, radii, queries.
// One of `every` passes then shoots for all, and its photons count `every` times. Which one is
// drawn anew each time, so that the expectation is right whenever a render ends.
#pragma once

#include <cstdint>

#include "aips/core/base/state_archive.h"

namespace aips {

struct PhotonTurns {
    std::uint32_t every = 1;  ///< a power of two
    std::uint64_t since = 0;  ///< pass that the first `every` passes begin with

    bool shoots(std::uint64_t seed, std::uint64_t pass) const;
    void state(StateArchive& archive);
};

}  // namespace aips
