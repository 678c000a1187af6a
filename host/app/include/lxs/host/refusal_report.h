// What a render refused because it was no light, for the statistics file and the end of the log.
#pragma once

#include <map>
#include <string>

#include "lxs/host/console_log.h"
#include "lxs/host/render_session.h"

namespace lxs {

/// What was refused by origin, by kind: "contributions" of the integrator, "texture values" of the
/// scene, "film samples". Kinds without refusals are absent.
using RefusalsByKind = std::map<std::string, RefusalList>;

/// `contributions`: Integrator::refusals().
RefusalsByKind refusals_by_kind(const RenderSession& session, RefusalList contributions);

/// One warning for each origin.
void warn_of_refusals(const RefusalsByKind& refused, ConsoleLog& log);

}  // namespace lxs
