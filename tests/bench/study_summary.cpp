// DIR/summary.json: all that a study found, for reports.
#include "study_summary.h"

#include <algorithm>

#include "comparison.h"
#include "run_record.h"

namespace bench {
namespace {

Json finished(const Json& runs) {
    Json done = Json::array();
    for (const Json& run : runs) {
        if (run.at("status") == "done") done.push_back(run);
    }
    return done;
}

Json revisions(const Json& runs) {
    Json list = Json::array();
    for (const Json& run : runs) {
        const Json& revision = run.at("revision");
        if (std::find(list.begin(), list.end(), revision) == list.end()) list.push_back(revision);
    }
    return list;
}

Json scene_facts(const BenchScene& scene, const Study& study, const Json& done,
                 ReferenceCache& cache) {
    Json facts{{"name", scene.name},
               {"file", scene.file.string()},
               {"width_px", nullptr},
               {"height_px", nullptr},
               {"reference", nullptr}};
    for (const Json& run : done) {
        const Json& settings = run.at("settings");
        if (settings.at("scene") != scene.name) continue;
        facts.update(run.at("image"));
        const References* references =
            cache.find(scene.name, settings.at("scene_sha1"), study.width_px);
        if (references != nullptr) facts["reference"] = references->metadata;
        break;
    }
    return facts;
}

}  // namespace

Json to_json(const Study& study) {
    Json scenes = Json::array();
    for (const BenchScene& scene : study.scenes)
        scenes.push_back(scene.name);
    Json seeds = Json::array();
    for (unsigned seed = 1; seed <= study.seeds; ++seed)
        seeds.push_back(seed);
    return {{"scenes", scenes},
            {"methods", study.methods},
            {"variants", study.variants},
            {"seeds", seeds},
            {"budgets_s", study.budgets_s},
            {"threads", study.threads},
            {"width_px", study.width_px},
            {"clock", study.clock},
            {"set", study.set},
            {"baseline", study.baseline}};
}

Json summarise(const std::filesystem::path& folder, const Study& study, const MethodTable& table,
               const Json& runs, ReferenceCache& references) {
    const Json settings = to_json(study);
    const Json done = finished(runs);
    Json scenes = Json::array();
    for (const BenchScene& scene : study.scenes)
        scenes.push_back(scene_facts(scene, study, done, references));
    Json methods = Json::array();
    for (const std::string& name : study.methods) {
        const Method& method = find_method(table.methods, name);
        methods.push_back({{"name", name},
                           {"description", method.description},
                           {"integrator", method.integrator},
                           {"has_variants", method.has_variants}});
    }
    return {{"schema", kSummarySchema},
            {"created", utc_now()},
            {"revisions", revisions(runs)},
            {"machine", runs.empty() ? Json() : runs.front().at("machine")},
            {"study", settings},
            {"scenes", scenes},
            {"methods", methods},
            {"runs", runs},
            {"seed_statistics", compare_seeds(folder, done, settings, references)},
            {"comparisons", compare_methods(done, settings)}};
}

}  // namespace bench
