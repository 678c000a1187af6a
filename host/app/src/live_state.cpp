// The state of a render as the page of --serve gets it.
#include "live_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>

#include "lxs/host/explanation.h"
#include "lxs/host/process_usage.h"

namespace lxs {
namespace {

using LiveJson = nlohmann::ordered_json;

constexpr std::size_t kMostPoints = 400;
constexpr std::size_t kMostLiveRows = 60;  ///< of a table; what brings most comes first

LiveJson of_curve(const LiveState& state) {
    LiveJson json;
    json["curve"] = LiveJson::array();
    for (const ErrorPoint& point : state.curve.points())
        json["curve"].push_back({point.seconds, point.error, point.passes});
    json["now"] = nullptr;
    if (!state.curve.points().empty()) json["now"] = state.curve.points().back().error;
    json["target"] = nullptr;
    if (state.target_error) json["target"] = *state.target_error;
    return json;
}

LiveJson of_budget(const Budget& budget) {
    LiveJson json = LiveJson::object();
    if (budget.passes) json["passes"] = *budget.passes;
    if (budget.seconds) json["seconds"] = *budget.seconds;
    return json;
}

/// The numbers of the rows that a table of `count` has room for, those with most `weight` first.
std::vector<std::size_t> first_rows(std::size_t count, const auto& weight) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::size_t rows = std::min(count, kMostLiveRows);
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(rows), order.end(),
                      [&](std::size_t a, std::size_t b) {
                          return std::pair(weight(a), b) > std::pair(weight(b), a);
                      });
    order.resize(rows);
    return order;
}

/// "light 3", and whose it is in words.
LiveJson of_live_light(const RenderSession& session, const LightStatistics& transport,
                       std::size_t i) {
    LiveJson json;
    const std::string title = light_name(session, i);
    json["name"] = fmt::format("{} {}", i, session.scene->lights()[i]->kind());
    json["title"] = title;
    json["photons"] = transport.photon_paths;
    json["counted"] = transport.counted_paths;
    json["luminance"] = transport.seen + transport.photons;
    json["by photons"] = transport.photons;
    return json;
}

LiveJson of_lights(const RenderSession& session, const TransportStatistics& transport) {
    std::vector<LightStatistics> lights(transport.lights);
    lights.resize(session.scene->lights().size());
    const auto rows = first_rows(lights.size(), [&](std::size_t i) {
        return std::pair(lights[i].seen + lights[i].photons, lights[i].photon_paths);
    });
    LiveJson json{{"rows", LiveJson::array()}};
    for (const std::size_t i : rows)
        json["rows"].push_back(of_live_light(session, lights[i], i));
    json["more"] = lights.size() - rows.size();
    json["luminance"] = told_luminance(transport);
    return json;
}

LiveJson of_materials(const RenderSession& session, const TransportStatistics& transport) {
    const auto names = session.scene->material_names();
    std::vector<MaterialStatistics> materials(transport.materials);
    materials.resize(names.size());
    const auto rows = first_rows(names.size(), [&](std::size_t i) { return materials[i].hits; });
    LiveJson json{{"rows", LiveJson::array()}};
    for (const std::size_t i : rows) {
        const MaterialStatistics& material = materials[i];
        json["rows"].push_back({{"name", names[i]},
                                {"hits", material.hits},
                                {"taken", material.taken},
                                {"unseen", material.unseen},
                                {"direct", material.direct},
                                {"passing", material.passing}});
    }
    json["more"] = names.size() - rows.size();
    return json;
}

LiveJson of_layers(const std::vector<std::string>& layers) {
    LiveJson json = LiveJson::array();
    for (const std::string& name : layers)
        json.push_back({{"name", name}});
    return json;
}

/// Why some overlays may not be there.
const char* hint(const std::vector<std::string>& layers) {
    const bool has = std::find(layers.begin(), layers.end(), "photondensity") != layers.end();
    return has ? "" : "Density and share of photons and the guide: --set aips.debuglayers=true.";
}

}  // namespace

void ErrorCurve::add(const RenderTotals& totals, const std::optional<ErrorEstimate>& estimate) {
    if (!estimate || estimate->passes == last_passes_) return;
    last_passes_ = estimate->passes;
    const ErrorPoint point{totals.seconds, estimate->relative(), estimate->passes};
    // The last point is always the latest estimate.
    if (seen_++ % every_ != 0 && !points_.empty()) {
        points_.back() = point;
        return;
    }
    points_.push_back(point);
    if (points_.size() < kMostPoints) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points_.size(); i += 2)
        points_[kept++] = points_[i];
    points_.resize(kept);
    points_.push_back(point);
    every_ *= 2;
}

std::string live_state_json(const CommandLine& command, const RenderSession& session,
                            const Budget& budget, const LiveState& state) {
    const RenderTotals& totals = state.totals;
    LiveJson json;
    json["title"] = std::filesystem::path(command.scene).filename().string();
    json["phase"] = state.phase;
    json["message"] = state.message;
    json["integrator"] = session.integrator_name;
    json["width"] = session.film->width();
    json["height"] = session.film->height();
    json["passes"] = totals.passes;
    json["seconds"] = totals.seconds;
    json["photons"] = totals.photon_paths;
    json["rays"] = totals.rays;
    json["memory"] = resident_bytes();
    json["budget"] = of_budget(budget);
    json["left"] = nullptr;
    if (const auto left = budget.remaining(totals.passes, totals.seconds)) json["left"] = *left;
    json["error"] = of_curve(state);
    json["layers"] = of_layers(state.layers);
    json["hint"] = hint(state.layers);
    if (state.transport) {
        json["lights"] = of_lights(session, *state.transport);
        if (told_photon_paths(*state.transport) > 0)
            json["materials"] = of_materials(session, *state.transport);
    }
    return json.dump(-1, ' ', false, LiveJson::error_handler_t::replace);
}

}  // namespace lxs
