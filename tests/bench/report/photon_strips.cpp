// Debug layers of a study's photon methods over the passes, as rows of small pictures.
#include "photon_strips.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "colour_scale.h"
#include "image_file.h"
#include "report_curves.h"
#include "run_errors.h"
#include "run_group.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kMostColumns = 6;
/// Tried in turn until all pictures fit.
constexpr int kWidths[] = {kStripPictureWidth, 112, 80};

struct Layer {
    const char* name;
    bool is_share;  ///< shown from 0 to 1
};

/// The last are the first to be left out.
constexpr Layer kLayers[] = {{"photondensity", false},
                             {"nodeerror", false},
                             {"nodeweight", false},
                             {"guidedshare", true},
                             {"nodeedges", true}};

/// Where a picture stands, and what it is of.
struct Picture {
    std::string method;
    std::size_t column = 0;
    const Json* snapshot = nullptr;
};

/// All that is shown of a layer in a scene.
struct Strip {
    std::string scene;
    const Layer* layer = nullptr;
    std::vector<Picture> pictures;  ///< by method, then column
    std::vector<PixelMap> maps;     ///< likewise; shrunk
};

/// Which snapshots: nothing for the first pass, then seconds of budgets.
using Columns = std::vector<std::optional<double>>;

Columns columns_of(const Json& study) {
    Columns columns{std::nullopt};
    const auto budgets = study.at("budgets_s").get<std::vector<double>>();
    const std::size_t count = std::min(budgets.size(), kMostColumns - 1);
    for (std::size_t i = 1; i <= count; ++i)
        columns.emplace_back(budgets[i * budgets.size() / count - 1]);
    return columns;
}

const Json* snapshot_of(const Json& run, const std::string& clock,
                        const std::optional<double>& budget_s) {
    const Json& snapshots = run.at("snapshots");
    if (snapshots.empty()) return nullptr;
    if (!budget_s) return &snapshots.front();
    const auto index = snapshot_for(run, clock, *budget_s);
    return index ? &snapshots[*index] : nullptr;
}

Strip find_strip(const fs::path& folder, const Json& runs, const Json& study,
                 const std::string& scene, const Layer& layer) {
    Strip strip{scene, &layer, {}, {}};
    const Columns columns = columns_of(study);
    const std::string clock = clocks_of(study).front();
    for (const std::string method : study.at("methods")) {
        const Json* run = find_run(runs, {scene, method, study.at("variants").front()},
                                   study.at("seeds").front());
        if (run == nullptr) continue;
        for (std::size_t column = 0; column < columns.size(); ++column) {
            const Json* snapshot = snapshot_of(*run, clock, columns[column]);
            if (snapshot == nullptr) continue;
            const fs::path file = folder / snapshot->at("exr").get<std::string>();
            if (!fs::exists(file)) continue;
            const auto map = read_map(file, layer.name);
            if (!map) continue;
            strip.pictures.push_back({method, column, snapshot});
            strip.maps.push_back(shrink(*map, kStripPictureWidth));
        }
    }
    return strip;
}

std::vector<Strip> find_strips(const fs::path& folder, const Json& runs, const Json& study) {
    std::vector<Strip> strips;
    for (const Layer& layer : kLayers) {
        for (const std::string scene : study.at("scenes")) {
            Strip strip = find_strip(folder, runs, study, scene, layer);
            if (!strip.maps.empty()) strips.push_back(std::move(strip));
        }
    }
    return strips;
}

/// PNG data URIs of the strips' pictures.
using Drawn = std::vector<std::vector<std::string>>;

ColourScale scale_of(const Strip& strip) {
    return strip.layer->is_share ? ColourScale{} : choose_scale(strip.maps);
}

Drawn draw(const std::vector<Strip>& strips, int width_px) {
    Drawn drawn;
    for (const Strip& strip : strips) {
        const ColourScale scale = scale_of(strip);
        auto& uris = drawn.emplace_back();
        for (const PixelMap& map : strip.maps)
            uris.push_back(png_data_uri(colour_map(shrink(map, width_px), scale)));
    }
    return drawn;
}

double size_of(const Drawn& drawn) {
    double bytes = 0;
    for (const auto& uris : drawn) {
        for (const std::string& uri : uris)
            bytes += double(uri.size());
    }
    return bytes;
}

/// Leaves whole layers out, the last first, until the rest fits; returns their names.
Json leave_out(std::vector<Strip>& strips, Drawn& drawn, double bytes) {
    Json names = Json::array();
    while (!strips.empty() && size_of(drawn) > bytes) {
        const Layer* last = strips.back().layer;
        names.push_back(last->name);
        while (!strips.empty() && strips.back().layer == last) {
            strips.pop_back();
            drawn.pop_back();
        }
    }
    return names;
}

Json rows_of(const Strip& strip, std::vector<std::string>& uris, std::size_t columns,
             const std::string& clock) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < uris.size(); ++i) {
        const auto& [method, column, snapshot] = strip.pictures[i];
        if (rows.empty() || rows.back().at("method") != method)
            rows.push_back({{"method", method}, {"pictures", std::vector<Json>(columns)}});
        rows.back()["pictures"][column] = {{"pass", snapshot->at("pass")},
                                           {"seconds", snapshot->at(clock + "_s")},
                                           {"image", std::move(uris[i])}};
    }
    return rows;
}

Json scenes_of(const Json& study, const std::vector<Strip>& strips, Drawn drawn) {
    Json scenes = Json::array();
    const std::size_t columns = columns_of(study).size();
    for (const Json& name : study.at("scenes")) {
        Json layers = Json::array();
        for (std::size_t i = 0; i < strips.size(); ++i) {
            if (name != strips[i].scene) continue;
            const ColourScale scale = scale_of(strips[i]);
            layers.push_back(
                {{"layer", strips[i].layer->name},
                 {"low", scale.low},
                 {"high", scale.high},
                 {"logarithmic", scale.logarithmic},
                 {"rows", rows_of(strips[i], drawn[i], columns, clocks_of(study).front())}});
        }
        if (!layers.empty()) scenes.push_back({{"scene", name}, {"layers", std::move(layers)}});
    }
    return scenes;
}

}  // namespace

Json report_photon_strips(const fs::path& folder, const Json& runs, const Json& study,
                          double bytes) {
    if (study.at("variants").empty() || study.at("seeds").empty()) return nullptr;
    std::vector<Strip> strips = find_strips(folder, runs, study);
    if (strips.empty()) return nullptr;
    Drawn drawn;
    for (const int width_px : kWidths) {
        drawn = draw(strips, width_px);
        if (size_of(drawn) <= bytes) break;
    }
    const Json left_out = leave_out(strips, drawn, bytes);
    Json columns = Json::array();
    for (const auto& budget_s : columns_of(study))
        columns.push_back(budget_s ? Json(*budget_s) : Json());
    return {{"variant", study.at("variants").front()},
            {"seed", study.at("seeds").front()},
            {"clock", clocks_of(study).front()},
            {"palette", colour_names(kMapColours)},
            {"columns", columns},
            {"left_out", left_out},
            {"scenes", scenes_of(study, strips, std::move(drawn))}};
}

}  // namespace bench
