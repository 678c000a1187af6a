// Which runs a study consists of, and in which order.
#include "study_plan.h"

namespace bench {
namespace {

RunSettings settings_for(const Study& study, const BenchScene& scene, const std::string& checksum,
                         const MethodTable& table, const Method& method, const std::string& variant,
                         unsigned seed) {
    RunSettings settings;
    settings.scene = scene.name;
    settings.scene_file = scene.file.string();
    settings.scene_sha1 = checksum;
    settings.width_px = study.width_px;
    settings.method = method.name;
    settings.variant = method.has_variants ? variant : kAny;
    settings.integrator = method.integrator;
    settings.sampler = method.sampler;
    settings.set = overrides(table, method, settings.variant, study.set);
    settings.seed = seed;
    settings.threads = study.threads;
    settings.budgets_s = study.budgets_s;
    settings.clock = study.clock;
    return settings;
}

}  // namespace

std::vector<RunSettings> plan_runs(const Study& study, const MethodTable& table) {
    std::vector<RunSettings> runs;
    for (const BenchScene& scene : study.scenes) {
        const std::string checksum = scene_checksum(scene.file);
        for (unsigned seed = 1; seed <= study.seeds; ++seed) {
            for (const std::string& variant : study.variants) {
                for (const std::string& name : study.methods) {
                    const Method& method = find_method(table.methods, name);
                    if (!method.has_variants && variant != study.variants.front()) continue;
                    runs.push_back(
                        settings_for(study, scene, checksum, table, method, variant, seed));
                }
            }
        }
    }
    return runs;
}

}  // namespace bench
