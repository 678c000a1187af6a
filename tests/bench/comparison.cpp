// What a study's runs say of its methods: errors against the baseline, bias and variance.
#include "comparison.h"

#include <vector>

#include "error_ratio.h"
#include "image_file.h"
#include "run_group.h"
#include "seed_statistics.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

using Group = RunGroup;

/// A budget on a clock.
struct Budget {
    std::string clock;
    double seconds = 0;
};

std::vector<Budget> budgets_of(const Json& study) {
    std::vector<Budget> budgets;
    for (const std::string clock : {"cpu", "wall"}) {
        if (study.at("clock") != "both" && study.at("clock") != clock) continue;
        for (const double seconds : study.at("budgets_s"))
            budgets.push_back({clock, seconds});
    }
    return budgets;
}

std::optional<double> error_of(const Json* run, const Budget& budget, const char* part,
                               const char* metric) {
    if (run == nullptr) return std::nullopt;
    for (const Json& entry : run->at("at_budget")) {
        if (entry.at("clock") != budget.clock || entry.at("budget_s") != budget.seconds) continue;
        if (entry.at(part).is_null() || entry.at(part).at(metric).is_null()) return std::nullopt;
        return entry.at(part).at(metric).get<double>();
    }
    return std::nullopt;
}

Json or_null(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json inverse(const std::optional<double>& value) {
    return value ? Json(1 / *value) : Json();
}

/// Nothing if no run of either has this part.
std::optional<Json> compare_groups(const Json& runs, const Json& study, const Group& group,
                                   const Budget& budget, const char* part, const char* metric) {
    Group base = group;
    base.method = study.at("baseline");
    std::vector<std::optional<double>> errors, baseline;
    for (const Json& seed : study.at("seeds")) {
        errors.push_back(error_of(find_run(runs, group, seed), budget, part, metric));
        baseline.push_back(error_of(find_run(runs, base, seed), budget, part, metric));
    }
    const ErrorRatio ratio = error_ratio(errors, baseline);
    if (ratio.used == 0) return std::nullopt;
    return Json{{"scene", group.scene},
                {"variant", group.variant},
                {"method", group.method},
                {"baseline", base.method},
                {"clock", budget.clock},
                {"budget_s", budget.seconds},
                {"part", part},
                {"metric", metric},
                {"ratio", or_null(ratio.ratio)},
                {"low", or_null(ratio.low)},
                {"high", or_null(ratio.high)},
                {"efficiency_ratio", inverse(ratio.ratio)},
                {"efficiency_low", inverse(ratio.high)},
                {"efficiency_high", inverse(ratio.low)},
                {"seeds", ratio.used},
                {"left_out", ratio.left_out}};
}

template <class Action>
void for_each_group(const Json& study, const Action& action) {
    for (const Json& scene : study.at("scenes")) {
        for (const Json& variant : study.at("variants")) {
            for (const Json& method : study.at("methods"))
                action(Group{scene, method, variant});
        }
    }
}

Json statistics_of_part(const std::vector<Image>& images, const ReferencePair& references,
                        double mse) {
    const SeedStatistics statistics = seed_statistics(images, references.first, references.second);
    return {{"mse", mse},
            {"bias2", statistics.bias2},
            {"variance", statistics.variance},
            {"rel_bias2", statistics.rel_bias2},
            {"rel_variance", statistics.rel_variance}};
}

/// The snapshots that a group's runs took for a budget.
std::vector<const Json*> snapshots_of(const Json& runs, const Json& study, const Group& group,
                                      const Budget& budget, std::vector<const Json*>& of_runs) {
    std::vector<const Json*> snapshots;
    for (const Json& seed : study.at("seeds")) {
        const Json* run = find_run(runs, group, seed);
        if (run == nullptr) continue;
        const auto index = snapshot_for(*run, budget.clock, budget.seconds);
        if (!index) continue;
        of_runs.push_back(run);
        snapshots.push_back(&run->at("snapshots")[*index]);
    }
    return snapshots;
}

/// Null if not all snapshots have this part, or there are fewer than two.
Json part_statistics(const fs::path& folder, const std::vector<const Json*>& snapshots,
                     const char* part, const char* layer, const ReferencePair& references) {
    std::vector<Image> images;
    double mse = 0;
    for (const Json* snapshot : snapshots) {
        const Json& error = snapshot->at("error");
        if (error.is_null() || error.at(part).is_null()) return nullptr;
        mse += error.at(part).at("mse").get<double>() / double(snapshots.size());
        images.push_back(*read_layer(folder / snapshot->at("exr").get<std::string>(), layer));
    }
    return images.size() < 2 ? Json() : statistics_of_part(images, references, mse);
}

}  // namespace

Json compare_methods(const Json& runs, const Json& study) {
    Json list = Json::array();
    for_each_group(study, [&](const Group& group) {
        for (const Budget& budget : budgets_of(study)) {
            for (const char* part : {"image", "photons"}) {
                for (const char* metric : {"mse", "relmse", "relmse_rest"}) {
                    if (auto entry = compare_groups(runs, study, group, budget, part, metric))
                        list.push_back(*std::move(entry));
                }
            }
        }
    });
    return list;
}

Json compare_seeds(const fs::path& folder, const Json& runs, const Json& study,
                   ReferenceCache& cache) {
    Json list = Json::array();
    for_each_group(study, [&](const Group& group) {
        for (const Budget& budget : budgets_of(study)) {
            std::vector<const Json*> of_runs;
            const auto snapshots = snapshots_of(runs, study, group, budget, of_runs);
            if (snapshots.size() < 2) continue;
            const Json& settings = of_runs.front()->at("settings");
            const References* references =
                cache.find(group.scene, settings.at("scene_sha1"), settings.at("width_px"));
            if (references == nullptr) continue;
            list.push_back(
                {{"scene", group.scene},
                 {"method", group.method},
                 {"variant", group.variant},
                 {"clock", budget.clock},
                 {"budget_s", budget.seconds},
                 {"seeds", snapshots.size()},
                 {"image", part_statistics(folder, snapshots, "image", "", references->image)},
                 {"photons", references->photons
                                 ? part_statistics(folder, snapshots, "photons", kPhotonLayer,
                                                   *references->photons)
                                 : Json()}});
        }
    });
    return list;
}

}  // namespace bench
