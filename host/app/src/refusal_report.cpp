// Refusals of all parts of a render.
#include "lxs/host/refusal_report.h"

#include <fmt/format.h>

namespace lxs {

RefusalsByKind refusals_by_kind(const RenderSession& session, RefusalList contributions) {
    RefusalsByKind kinds;
    const auto add = [&](const char* kind, RefusalList list) {
        if (!list.empty()) kinds.emplace(kind, std::move(list));
    };
    add("contributions", std::move(contributions));
    add("texture values", session.scene->refused_values());
    add("film samples", session.film->refusals());
    return kinds;
}

void warn_of_refusals(const RefusalsByKind& refused, ConsoleLog& log) {
    for (const auto& [kind, list] : refused) {
        for (const Refusal& refusal : list) {
            log.warning(fmt::format("refused {} {} of {}: not finite or negative", refusal.count,
                                    kind, refusal.origin));
        }
    }
}

}  // namespace lxs
