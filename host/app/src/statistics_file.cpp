// The JSON file that a render leaves beside its image.
#include "lxs/host/statistics_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lxs/host/error_json.h"
#include "lxs/host/explanation.h"
#include "lxs/host/process_usage.h"

namespace lxs {
namespace {

using Json = nlohmann::ordered_json;

double per(double count, double seconds) {
    return seconds > 0 ? count / seconds : 0;
}

Json settings(const CommandLine& command, const RenderSession& session) {
    Json json;
    json["scene"] = command.scene;
    json["integrator"] = session.integrator_name;
    json["seed"] = session.seed;
    json["threads"] = command.threads;
    json["set"] = command.overrides;
    if (command.passes) json["passes"] = *command.passes;
    if (command.seconds) json["seconds"] = *command.seconds;
    if (command.target_error) json["target error"] = *command.target_error;
    return json;
}

Json scene_facts(const RenderSession& session) {
    const SceneFacts facts = session.scene->facts();
    Json json;
    json["width"] = session.film->width();
    json["height"] = session.film->height();
    json["triangles"] = facts.triangles;
    json["quadrics"] = facts.quadrics;
    json["lights"] = session.scene->lights().size();
    json["light groups"] = session.scene->light_groups();
    json["materials"] = session.scene->material_names().size();
    json["diffuse"] = facts.has_diffuse;
    json["glossy"] = facts.has_glossy;
    json["specular"] = facts.has_specular;
    json["transmission"] = facts.has_transmission;
    json["media"] = facts.has_media;
    json["motion"] = facts.has_motion;
    json["image textures"] = facts.has_image_textures;
    return json;
}

Json counts(const RenderTotals& totals) {
    const auto photons = static_cast<double>(totals.photon_paths);
    const auto rays = static_cast<double>(totals.rays);
    Json json;
    json["passes"] = totals.passes;
    json["samples per pixel"] = totals.samples_per_pixel;
    json["photon paths"] = totals.photon_paths;
    json["rays"] = totals.rays;
    json["photon paths per second"] = per(photons, totals.seconds);
    json["rays per second"] = per(rays, totals.seconds);
    json["photon paths per CPU second"] = per(photons, totals.cpu_seconds);
    json["rays per CPU second"] = per(rays, totals.cpu_seconds);
    return json;
}

/// By kind and origin; empty on a healthy scene.
Json by_origin(const InvalidSamplesByKind& refused) {
    Json json = Json::object();
    for (const auto& [kind, list] : refused) {
        for (const InvalidSamples& invalid : list)
            json[kind][invalid.origin] = invalid.count;
    }
    return json;
}

Json verdict(const ImageVerdict& image) {
    Json json;
    json["appearance"] = image.name();
    if (!image.reason.empty()) json["likely reason"] = image.reason;
    return json;
}

Json of_light(const RenderSession& session, const TransportStatistics& transport,
              std::size_t light) {
    Json json;
    json["name"] = light_name(session, light);
    if (light >= transport.lights.size()) return json;
    const LightStatistics& told = transport.lights[light];
    json["photon paths"] = told.photon_paths;
    json["counted photon paths"] = told.counted_paths;
    json["luminance seen"] = told.seen;
    json["luminance by photons"] = told.photons;
    return json;
}

Json of_material(const MaterialStatistics& material) {
    Json json;
    json["hits"] = material.hits;
    json["taken"] = material.taken;
    json["not in view"] = material.unseen;
    json["left to shadow rays"] = material.direct;
    json["only pass"] = material.passing;
    json["black"] = material.black;
    json["ended by depth"] = material.cut;
    return json;
}

Json transport_of(const RenderSession& session, const TransportStatistics& transport) {
    Json json;
    Json& lights = json["lights"] = Json::array();
    for (std::size_t i = 0; i < session.scene->lights().size(); ++i)
        lights.push_back(of_light(session, transport, i));
    Json& materials = json["materials"] = Json::object();
    const auto names = session.scene->material_names();
    for (std::size_t i = 0; i < std::min(names.size(), transport.materials.size()); ++i)
        materials[names[i]] = of_material(transport.materials[i]);
    json["eye paths"] = transport.eye_paths;
    json["eye paths ended by depth"] = transport.cut_eye_paths;
    json["media"] = session.scene->media_notes();
    json["left out"] = transport.skipped;
    for (const auto& [stage, seconds] : transport.seconds)
        json["seconds"][stage] = seconds;
    return json;
}

Json advice_of(const std::vector<Advice>& advice) {
    Json json = Json::array();
    for (const Advice& one : advice)
        json.push_back({{"rule", one.rule}, {"text", one.text}});
    return json;
}

Json traffic_of(const RankJob& job) {
    const RankTraffic traffic = job.traffic();
    Json json;
    json["processes"] = job.count();
    json["exchanges"] = traffic.exchanges;
    json["bytes told"] = traffic.told_bytes;
    json["bytes heard"] = traffic.heard_bytes;
    json["seconds waiting"] = traffic.waiting_seconds;
    json["seconds of transfer"] = traffic.transfer_seconds;
    return json;
}

}  // namespace

std::string statistics_json(const CommandLine& command, const RenderSession& session,
                            const RenderTotals& totals, const RenderFigures& figures,
                            bool interrupted) {
    Json json;
    json["version"] = version();
    json["interrupted"] = interrupted;
    json["settings"] = settings(command, session);
    json["scene"] = scene_facts(session);
    if (figures.image) json["image"] = verdict(*figures.image);
    if (const auto error = session.film->error()) json["estimated error"] = error_json(*error);
    json["seconds"] = session.times;
    json["render CPU seconds"] = totals.cpu_seconds;
    json["counts"] = counts(totals);
    if (session.job) json["mpi"] = traffic_of(*session.job);
    if (const auto share = session.film->outliers_left_out())
        json["share of light left out of the display"] = *share;
    json["peak memory bytes"] = peak_resident_bytes();
    json["film memory bytes"] = session.film->memory_bytes();
    json["refused film samples"] = session.film->refused_samples();
    json["refused"] = by_origin(figures.refused);
    if (figures.transport) {
        json["account"] = transport_of(session, *figures.transport);
        json["advice"] = advice_of(figures.advice);
    }
    Json& own = json[session.integrator_name] = Json::object();
    for (const auto& [name, value] : figures.own) {
        std::visit([&, &key = name](const auto& figure) { own[key] = figure; }, value);
    }
    // Names of the scene may hold any bytes, JSON holds UTF-8 alone.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace lxs
