// `aips-bench agreement`: do a study's methods agree with the references within noise and bias?
#include "agreement_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <utility>

#include "agreement_samples.h"
#include "agreement_table.h"
#include "method_table.h"
#include "reference_checks.h"
#include "run_record.h"
#include "scene_table.h"
#include "study_summary.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReferences = "references";

struct StudyFiles {
    fs::path folder;
    Json summary;
};

/// A scene of the study, with all that its methods are compared with.
struct Scene {
    BenchScene listed;
    std::string baseline;
    Json metadata;  ///< of the references
    BlockSample references;
    std::map<std::string, SeedBlocks> methods;  ///< by name
    std::optional<RadiusBias> bias;             ///< nothing if no smaller radius was given
};

StudyFiles read_study(const fs::path& folder) {
    return {folder, read_json(folder / "summary.json", kSummarySchema)};
}

/// Settings that all runs of a scene share; null without runs.
Json settings_of(const Json& summary, const std::string& scene) {
    for (const Json& run : summary.at("runs")) {
        if (run.at("settings").at("scene") == scene) return run.at("settings");
    }
    return nullptr;
}

Json read_references(const fs::path& root, const std::string& scene, const Json& settings) {
    const std::uint32_t width_px = settings.at("width_px"), height_px = settings.at("height_px");
    Json metadata = read_reference_metadata(reference_folder(root, scene, width_px, height_px),
                                            scene, settings.at("scene_sha1"), width_px, height_px);
    for (const char* name : kReferenceNames) {
        if (!metadata.at("images").contains(name)) {
            throw StudyError(
                fmt::format("scene \"{}\" has no references in '{}'", scene, root.string()));
        }
    }
    return metadata;
}

/// Throws StudyError if the other study can't tell the bias of this one.
RadiusBias measure_bias(const StudyFiles& smaller, const Scene& scene, double radius,
                        const Json& settings) {
    const RunGroup group{scene.listed.name, scene.baseline, kFixed};
    const auto radius_there = radius_of_runs(smaller.summary, group);
    if (!radius_there || *radius_there >= radius) {
        throw StudyError(
            fmt::format("'{}' has no runs of \"{}\" on \"{}\" at a fixed radius below {:g}",
                        smaller.folder.string(), group.method, group.scene, radius));
    }
    const Json there = settings_of(smaller.summary, group.scene);
    for (const char* key : {"scene_sha1", "width_px", "height_px"}) {
        if (there.at(key) != settings.at(key)) {
            throw StudyError(fmt::format("'{}' has \"{}\" with another {}", smaller.folder.string(),
                                         group.scene, key));
        }
    }
    return {scene.methods.at(scene.baseline),
            blocks_of_runs(smaller.folder, smaller.summary, group),
            bias_factors(radius, *radius_there, reference_radii(scene.metadata))};
}

Scene read_scene(const AgreementRequest& request, const StudyFiles& study,
                 const std::optional<StudyFiles>& smaller, const std::string& name) {
    Scene scene;
    scene.listed = listed_scene(name, request.scene_table);
    scene.baseline = study.summary.at("study").at("baseline");
    const Json settings = settings_of(study.summary, name);
    scene.metadata = read_references(request.references, name, settings);
    scene.references = blocks_of_references(scene.metadata);
    for (const std::string method : study.summary.at("study").at("methods")) {
        scene.methods[method] = blocks_of_runs(study.folder, study.summary, {name, method, kFixed});
    }
    const auto radius = radius_of_runs(study.summary, {name, scene.baseline, kFixed});
    if (smaller && radius) scene.bias = measure_bias(*smaller, scene, *radius, settings);
    return scene;
}

Json place(const statistics::Comparison& comparison) {
    if (comparison.smallest_at + 1 == comparison.tests) return nullptr;
    const auto block = int(comparison.smallest_at);
    return {{"row", block / kBlocksPerSide}, {"column", block % kBlocksPerSide}};
}

const char* verdict(const Agreement& found, bool misses) {
    if (misses) return "does not converge";
    if (found.comparison.differs()) return "differs";
    return found.agrees() ? "agrees" : "open";
}

Json to_json(const Agreement& found, const Scene& scene, const std::string& method,
             const std::string& against) {
    const auto misses = scene.listed.misses.find(method);
    const bool is_missing = misses != scene.listed.misses.end();
    const statistics::Comparison& test = found.comparison;
    const RatioInterval interval = found.ratio_interval();
    return {{"scene", scene.listed.name},
            {"variant", kFixed},
            {"method", method},
            {"against", against},
            {"seeds", found.seeds},
            {"mean_ratio", found.mean_ratio},
            {"claimed_bias", found.bias ? Json(*found.bias) : Json()},
            {"weighted_ratio", test.mean_ratio},
            {"weighted_low", interval.low},
            {"weighted_high", interval.high},
            {"standard_error", test.standard_error},
            {"smallest_p", test.smallest_p},
            {"threshold", test.threshold},
            {"smallest_at", place(test)},
            {"detectable", test.detectable},
            {"detectable_in_block", test.detectable_in_block},
            {"misses", is_missing ? Json(misses->second) : Json()},
            {"verdict", verdict(found, is_missing)}};
}

/// Weights of the blocks from all methods but those compared: where noise is skewed, as that of
/// rare bright paths, weights from the same images would prefer the blocks without such paths.
std::vector<double> weights_without(const Scene& scene, const std::set<std::string>& compared) {
    std::vector<statistics::BlockMeans> samples;
    for (const auto& [method, blocks] : scene.methods) {
        if (blocks.size() >= 2 && !compared.contains(method)) samples.push_back(all_means(blocks));
    }
    return block_weights(samples);
}

/// The method's rows: against the references, and against the baseline if both have one radius.
void test_method(const StudyFiles& study, const Scene& scene, const std::string& method, Json& rows,
                 lxs::ConsoleLog& log) {
    const RunGroup group{scene.listed.name, method, kFixed};
    const auto radius = radius_of_runs(study.summary, group);
    const SeedBlocks& blocks = scene.methods.at(method);
    const RadiusBias* bias = radius && scene.bias ? &*scene.bias : nullptr;
    const auto found =
        agreement_with_references(scene.references, blocks, bias, weights_without(scene, {method}));
    if (!found) {
        log.warning(
            fmt::format("{}: \"{}\" has fewer than three runs to test", group.scene, method));
        return;
    }
    rows.push_back(to_json(*found, scene, method, kReferences));
    const RunGroup baseline{scene.listed.name, scene.baseline, kFixed};
    if (!radius || method == scene.baseline || radius != radius_of_runs(study.summary, baseline))
        return;
    if (const auto same = agreement_with_baseline(scene.methods.at(scene.baseline), blocks,
                                                  weights_without(scene, {method, scene.baseline})))
        rows.push_back(to_json(*same, scene, method, scene.baseline));
}

Json test_all(const AgreementRequest& request, const StudyFiles& study, lxs::ConsoleLog& log) {
    const Json& settings = study.summary.at("study");
    if (std::ranges::find(settings.at("variants"), Json(kFixed)) == settings.at("variants").end()) {
        throw StudyError(
            fmt::format("'{}' has no variant \"{}\", in which methods have one "
                        "expected image",
                        study.folder.string(), kFixed));
    }
    std::optional<StudyFiles> smaller;
    if (!request.smaller_radius.empty()) smaller = read_study(request.smaller_radius);
    Json rows = Json::array();
    for (const std::string name : settings.at("scenes")) {
        const Scene scene = read_scene(request, study, smaller, name);
        for (const std::string method : settings.at("methods"))
            test_method(study, scene, method, rows, log);
    }
    return rows;
}

}  // namespace

ExitCode test_agreement(const AgreementRequest& request, lxs::ConsoleLog& log) {
    const StudyFiles study = read_study(request.folder);
    const Json rows = test_all(request, study, log);
    const Json document{{"schema", kAgreementSchema},
                        {"created", utc_now()},
                        {"study", study.summary["study"]},
                        {"significance", kDisagreement},
                        {"decisive", kDecisive},
                        {"smaller_radius", request.smaller_radius.string()},
                        {"tests", rows}};
    write_json(request.folder / "agreement.json", document);
    std::fputs(agreement_table(document).c_str(), stdout);
    const bool differs =
        std::ranges::any_of(rows, [](const Json& row) { return row.at("verdict") == "differs"; });
    return differs ? ExitCode::MethodsDiffer : ExitCode::Success;
}

}  // namespace bench
