// Invalid samples of all parts of a render.
#include "lxs/host/invalid_sample_report.h"

#include <fmt/format.h>

namespace lxs {

InvalidSamplesByKind invalid_samples_by_kind(const RenderSession& session,
                                             InvalidSampleList contributions) {
    InvalidSamplesByKind kinds;
    const auto add = [&](const char* kind, InvalidSampleList list) {
        if (!list.empty()) kinds.emplace(kind, std::move(list));
    };
    add("contributions", std::move(contributions));
    add("texture values", session.scene->refused_values());
    add("film samples", session.film->invalid_samples());
    return kinds;
}

void warn_of_invalid_samples(const InvalidSamplesByKind& refused, ConsoleLog& log) {
    for (const auto& [kind, list] : refused) {
        for (const InvalidSamples& invalid : list) {
            log.warning(fmt::format("refused {} {} of {}: not finite or negative", invalid.count,
                                    kind, invalid.origin));
        }
    }
}

}  // namespace lxs
