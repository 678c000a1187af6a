// What one run is asked to be.
#include "run_settings.h"

#include <fmt/format.h>

namespace bench {

Json to_json(const RunSettings& settings) {
    return {{"scene", settings.scene},
            {"scene_file", settings.scene_file},
            {"scene_sha1", settings.scene_sha1},
            {"width_px", settings.width_px},
            {"height_px", settings.height_px},
            {"method", settings.method},
            {"variant", settings.variant},
            {"integrator", settings.integrator},
            {"sampler", settings.sampler},
            {"set", settings.set},
            {"seed", settings.seed},
            {"threads", settings.threads},
            {"budgets_s", settings.budgets_s},
            {"passes", settings.passes},
            {"clock", settings.clock}};
}

RunSettings run_settings_from(const Json& json) {
    RunSettings settings;
    json.at("scene").get_to(settings.scene);
    json.at("scene_file").get_to(settings.scene_file);
    json.at("scene_sha1").get_to(settings.scene_sha1);
    json.at("width_px").get_to(settings.width_px);
    json.at("height_px").get_to(settings.height_px);
    json.at("method").get_to(settings.method);
    json.at("variant").get_to(settings.variant);
    json.at("integrator").get_to(settings.integrator);
    json.at("sampler").get_to(settings.sampler);
    json.at("set").get_to(settings.set);
    json.at("seed").get_to(settings.seed);
    json.at("threads").get_to(settings.threads);
    json.at("budgets_s").get_to(settings.budgets_s);
    json.at("passes").get_to(settings.passes);
    json.at("clock").get_to(settings.clock);
    return settings;
}

std::string run_name(const RunSettings& settings) {
    return fmt::format("{}.{}.{}.s{}", settings.scene, settings.method, settings.variant,
                       settings.seed);
}

Json to_json(const RenderJob& job) {
    return {{"settings", to_json(job.settings)},
            {"images", job.images},
            {"png", job.png},
            {"final_only", job.final_only},
            {"result", job.result}};
}

RenderJob render_job_from(const Json& json) {
    return {run_settings_from(json.at("settings")), json.at("images"), json.at("png"),
            json.at("final_only"), json.at("result")};
}

}  // namespace bench
