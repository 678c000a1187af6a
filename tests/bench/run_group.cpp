// Runs of a study that differ by their seed alone.
#include "run_group.h"

#include "method_table.h"

namespace bench {

const Json* find_run(const Json& runs, const RunGroup& group, const Json& seed) {
    for (const Json& run : runs) {
        const Json& settings = run.at("settings");
        const Json& variant = settings.at("variant");
        if (settings.at("scene") == group.scene && settings.at("method") == group.method &&
            (variant == group.variant || variant == kAny) && settings.at("seed") == seed)
            return &run;
    }
    return nullptr;
}

}  // namespace bench
