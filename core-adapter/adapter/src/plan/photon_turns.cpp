// The draw of the passes that shoot.
#include "plan/photon_turns.h"

#include <bit>

#include "aips/core/sampling/random.h"
#include "plan/constants.h"

namespace aips {

bool PhotonTurns::shoots(std::uint64_t seed, std::uint64_t pass) const {
    if (every == 1 || pass < since) return true;
    RandomStream random(seed, since, (pass - since) / every, RandomDomain::PhotonTurn);
    return (pass - since) % every == random.next_uint() % every;
}

void PhotonTurns::state(StateArchive& archive) {
    archive.value(every);
    archive.value(since);
    StateArchive::check(std::has_single_bit(every) && every <= kMostTurns,
                        "passes without photons that there are not");
}

}  // namespace aips
