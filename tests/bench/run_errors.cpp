// The errors of a run's snapshots, put into its document.
#include "run_errors.h"

#include "budget_curve.h"
#include "image_file.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

Json to_json(const ImageError& error) {
    return {{"mse", error.mse},
            {"rmse", error.rmse},
            {"relmse", error.relmse},
            {"relmse_rest", error.relmse_rest},
            {"epsilon", error.epsilon},
            {"worst",
             {{"pixels", error.worst.pixels},
              {"relmse", error.worst.relmse},
              {"share", error.worst.share}}}};
}

Json snapshot_error(const fs::path& file, const References& references) {
    Json error{{"image", nullptr}, {"photons", nullptr}};
    try {
        const auto& [first, second] = references.image;
        error["image"] = to_json(measure_error(read_image(file), first, second));
        const auto photons = read_layer(file, kPhotonLayer);
        if (photons && references.photons) {
            error["photons"] = to_json(
                measure_error(*photons, references.photons->first, references.photons->second));
        }
    } catch (const std::invalid_argument&) {
        throw StudyError("'" + file.string() + "' and the scene's references differ in size");
    }
    return error;
}

/// Points of the curve of one part's figure over a clock; empty if the part is not measured.
std::vector<CurvePoint> curve(const Json& snapshots, const std::string& clock, const char* part,
                              const char* figure) {
    std::vector<CurvePoint> points;
    for (const Json& snapshot : snapshots) {
        const Json& error = snapshot.at("error");
        if (error.is_null() || error.at(part).is_null()) continue;
        points.push_back({snapshot.at(clock + "_s"), error.at(part).at(figure)});
    }
    return points;
}

Json efficiency(const Json& error, double seconds) {
    return error.is_number() && error.get<double>() > 0 ? Json(1 / (error.get<double>() * seconds))
                                                        : Json();
}

Json part_at(const Json& snapshots, const std::string& clock, double budget_s, const char* part) {
    Json figures = Json::object();
    for (const char* figure : {"mse", "rmse", "relmse", "relmse_rest"}) {
        const auto points = curve(snapshots, clock, part, figure);
        if (points.empty()) return nullptr;
        const auto error = error_at(points, budget_s);
        figures[figure] = error ? Json(*error) : Json();
    }
    figures["efficiency_mse"] = efficiency(figures["mse"], budget_s);
    figures["efficiency_relmse"] = efficiency(figures["relmse"], budget_s);
    return figures;
}

}  // namespace

const References* ReferenceCache::find(const std::string& scene, const std::string& scene_sha1,
                                       std::uint32_t width_px, std::uint32_t height_px) {
    const auto [entry, is_new] =
        known_.try_emplace(reference_folder(root_, scene, width_px, height_px));
    if (is_new) {
        entry->second = load_references(root_, scene, scene_sha1, width_px, height_px);
    }
    return entry->second ? &*entry->second : nullptr;
}

std::optional<std::size_t> snapshot_for(const Json& run, const std::string& clock,
                                        double budget_s) {
    const Json& snapshots = run.at("snapshots");
    for (std::size_t i = 0; i < snapshots.size(); ++i) {
        for (const Json& mark : snapshots[i].at("marks")) {
            if (mark.at("clock") == clock && mark.at("seconds") == budget_s) return i;
        }
    }
    return std::nullopt;
}

Json errors_at_budgets(const Json& run) {
    const Json& settings = run.at("settings");
    Json list = Json::array();
    for (const double budget_s : settings.at("budgets_s")) {
        for (const std::string clock : {"cpu", "wall"}) {
            const auto snapshot = snapshot_for(run, clock, budget_s);
            if (!snapshot) continue;
            const Json& snapshots = run.at("snapshots");
            list.push_back({{"budget_s", budget_s},
                            {"clock", clock},
                            {"snapshot", *snapshot},
                            {"image", part_at(snapshots, clock, budget_s, "image")},
                            {"photons", part_at(snapshots, clock, budget_s, "photons")}});
        }
    }
    return list;
}

bool measure_run(const fs::path& folder, const References* references, Json& run) {
    const Json checksums = references != nullptr ? references->checksums() : Json();
    const bool measured =
        run.at("snapshots").front().contains("error") && run.at("references") == checksums;
    if (measured) return false;
    for (Json& snapshot : run["snapshots"]) {
        const fs::path file = folder / snapshot.at("exr").get<std::string>();
        snapshot["error"] = references != nullptr ? snapshot_error(file, *references) : Json();
    }
    run["references"] = checksums;
    run["at_budget"] = errors_at_budgets(run);
    return true;
}

}  // namespace bench
