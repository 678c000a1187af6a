// What a render refused because it was no light, for the statistics file and the end of the log.
#pragma once

#include <map>
#include <string>

#include "lxs/host/console_log.h"
#include "lxs/host/render_session.h"

namespace lxs {

/// What was refused by origin, by kind: "contributions" of the integrator, "texture values" of the
/// scene, "film samples". Kinds without any are absent.
using InvalidSamplesByKind = std::map<std::string, InvalidSampleList>;

/// `contributions`: Integrator::invalid_samples().
InvalidSamplesByKind invalid_samples_by_kind(const RenderSession& session,
                                             InvalidSampleList contributions);

/// One warning for each origin.
void warn_of_invalid_samples(const InvalidSamplesByKind& refused, ConsoleLog& log);

}  // namespace lxs
