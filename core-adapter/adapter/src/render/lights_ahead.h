// Learns which lights light what is seen, before the first pass.
#pragma once

#include <cstdint>

#include "eye/eye_pass.h"

namespace aips {

/// Traces eye paths at one time, of which nothing is kept but what their shadow rays found, so that
/// `lights`, those of `pass`, are chosen by that. Without it the first pass chooses them by power,
/// and where most are hidden is as noisy as a dozen later ones. Does nothing where there is no
/// choice, or something was learned before. Returns the rays traced. Neither the result nor what is
/// learned depends on the number of threads, nor on that of ranks.
std::uint64_t learn_lights_ahead(const EyePassInput& pass, float time, DirectLight& lights);

}  // namespace aips
