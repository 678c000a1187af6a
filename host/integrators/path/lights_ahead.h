// Learns which lights light what is seen, before the first pass.
#pragma once

#include "lxs/sdk/integrator.h"
#include "path/path_settings.h"
#include "path/path_tracer.h"

namespace lxs {

/// Traces eye paths of which nothing is kept but what their first shadow rays tell, and has
/// `lights` chosen by that: else the first pass would choose them by power. Does nothing where
/// there is no choice, or something was learned before. Returns the rays traced. Neither they nor
/// what is learned depend on the number of threads.
std::uint64_t learn_lights_ahead(const RenderContext& context, const PathSettings& settings,
                                 LightSelector& lights);

}  // namespace lxs
