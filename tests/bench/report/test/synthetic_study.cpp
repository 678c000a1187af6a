// A study whose every figure is known: errors that are power laws of time, images off by a constant
// factor.
#include "synthetic_study.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "comparison.h"
#include "image_file.h"
#include "reference_store.h"
#include "run_errors.h"
#include "study_summary.h"
#include "synthetic_image.h"

namespace bench::test {
namespace {

namespace fs = std::filesystem;

struct SyntheticMethod {
    const char* name;
    double error;            ///< relative to sppm
    double brightness;       ///< relative to the truth
    std::size_t layers = 0;  ///< how many of kLayers
};

constexpr SyntheticMethod kMethods[] = {
    {"sppm", 1, 1, 1}, {"better", 0.5, 1.1, 5}, {"worse", 2, 0.8}};
constexpr const char* kLayers[] = {"photondensity", "nodeerror", "nodeweight", "nodeedges",
                                   "guidedshare"};
constexpr double kTimes[] = {0.5, 1, 2, 4.2};
constexpr const char* kChecksum = "0123456789abcdef0123456789abcdef01234567";

Image picture(double brightness) {
    return synthetic_image(kSyntheticWidth, 30,
                           [&](int x, int y) { return brightness * (1 + x + 2 * y) / 100; });
}

/// Density grows to the right over four decades; columns of node boundaries stand closer with time;
/// all else is a share that grows with time.
Image layer_map(const std::string& layer, std::size_t time) {
    const Image map = synthetic_image(kSyntheticWidth, 30, [&](int x, int) {
        if (layer == "photondensity") return std::pow(10.0, x / 10.0);
        if (layer == "nodeedges") return x % int(10 - 2 * time) == 0 ? 1.0 : 0.0;
        return 0.2 * double(time + 1);
    });
    return OIIO::ImageBufAlgo::channels(map, 1, 0);
}

Json study_settings() {
    return {{"scenes", {kPlainScene, kNastyScene}},
            {"methods", {"sppm", "better", "worse"}},
            {"variants", {"fixed", "shipped"}},
            {"seeds", {1, 2}},
            {"budgets_s", {1.0, 2.0, 4.0}},
            {"threads", 1},
            {"width_px", 0},
            {"clock", "both"},
            {"set", Json::array()},
            {"baseline", "sppm"}};
}

Json marks_at(double seconds) {
    Json marks = Json::array();
    const double budget_s = seconds > 4 ? 4 : seconds;
    for (const char* clock : {"cpu", "wall"})
        marks.push_back({{"clock", clock}, {"seconds", budget_s}});
    return marks;
}

Json error_figures(double error) {
    return {{"mse", error / 10}, {"rmse", 0},
            {"relmse", error},   {"relmse_rest", error / 2},
            {"epsilon", 1e-4},   {"worst", {{"pixels", 1}, {"relmse", 1}, {"share", 0}}}};
}

Json snapshot(const std::string& exr, double seconds, double error, const Json& photons) {
    return {{"pass", int(10 * seconds)},
            {"wall_s", seconds},
            {"cpu_s", seconds},
            {"resident_bytes", 1 << 27},
            {"marks", marks_at(seconds)},
            {"exr", exr},
            {"png", nullptr},
            {"error", {{"image", error_figures(error)}, {"photons", photons}}}};
}

/// Of a method in a scene after one of kTimes. Without debug layers it stays the same.
std::string image_name(const std::string& scene, const SyntheticMethod& method, std::size_t time) {
    if (scene != kPlainScene || method.layers == 0)
        return fmt::format("images/{}.exr", method.name);
    return fmt::format("images/{}.{}.exr", method.name, time);
}

Json run_of(const std::string& scene, const SyntheticMethod& method, const char* variant,
            int seed) {
    Json snapshots = Json::array(), trace = Json::array();
    for (std::size_t time = 0; time < std::size(kTimes); ++time) {
        const double seconds = kTimes[time];
        const double error = method.error * (seed == 1 ? 1.0 : 1 + 0.01 * method.error);
        const Json photons =
            scene == kPlainScene ? error_figures(error * error * 8 / seconds) : Json();
        snapshots.push_back(
            snapshot(image_name(scene, method, time), seconds, error * 8 / seconds, photons));
        trace.push_back({{"pass", int(10 * seconds)}, {"resident_bytes", 1 << 27}});
    }
    Json run{
        {"schema", "aips-bench-run-1"},
        {"status", "done"},
        {"revision", "0123456789ab"},
        {"settings",
         {{"scene", scene},
          {"scene_sha1", kChecksum},
          {"width_px", 0},
          {"method", method.name},
          {"variant", variant},
          {"seed", seed},
          {"budgets_s", {1.0, 2.0, 4.0}}}},
        {"machine", {{"processor", "abacus"}, {"hardware_threads", 1}, {"system", "none"}}},
        {"image", {{"width_px", kSyntheticWidth}, {"height_px", 30}}},
        {"phases",
         {{"load_s", 0.01},
          {"build_s", 0.02},
          {"prepare_s", 0.0},
          {"render_wall_s", 4.2},
          {"render_cpu_s", 4.2},
          {"snapshots_s", 0.1}}},
        {"totals",
         {{"passes", 42}, {"photon_paths", 42000}, {"rays", 84000}, {"samples_per_pixel", 42}}},
        {"peak_memory_bytes", 1 << 27},
        {"refused_film_samples", 0},
        {"integrator_statistics",
         {{"eye_seconds", 1.05}, {"photon_seconds", 2.1}, {"radius", 0.5}}},
        {"trace", trace},
        {"snapshots", snapshots}};
    run["at_budget"] = errors_at_budgets(run);
    return run;
}

Json write_references(const fs::path& root, const std::string& scene) {
    const fs::path folder = reference_folder(root, scene, 0);
    Json metadata = read_reference_metadata(folder, scene, kChecksum, 0);
    for (const char* name : kReferenceNames) {
        const std::string file = fmt::format("{}.1.exr", name);
        const GrowingReference reference{one_chunk(picture(1), 1), std::nullopt};
        metadata["images"][name] = {{"file", file},
                                    {"sha1", write_reference(folder / file, reference)},
                                    {"method", "path"},
                                    {"weight", 1.0},
                                    {"cpu_s", 60.0},
                                    {"standard_error", nullptr},
                                    {"chunks", {{{"seed", 1}}}}};
    }
    write_json(folder / "reference.json", metadata);
    return metadata;
}

Json scene_facts(const fs::path& root, const std::string& scene) {
    return {{"name", scene},
            {"file", scene + ".lxs"},
            {"width_px", kSyntheticWidth},
            {"height_px", 30},
            {"reference", write_references(root, scene)}};
}

Json statistics_figures(double mse, double bias2) {
    return {{"mse", mse},
            {"bias2", bias2},
            {"variance", mse - bias2},
            {"rel_bias2", 10 * bias2},
            {"rel_variance", 10 * (mse - bias2)}};
}

/// At a budget, whatever variant and clock.
Json statistics_of(const std::string& scene, const SyntheticMethod& method, double budget_s) {
    const double mse = method.error / budget_s;
    const double bias2 = method.error == 1 ? kSyntheticBias2 : method.error / 100;
    const bool has_photons = scene == kPlainScene;
    return {{"scene", scene},
            {"method", method.name},
            {"budget_s", budget_s},
            {"seeds", 2},
            {"image", statistics_figures(mse, bias2)},
            {"photons", has_photons ? statistics_figures(mse / 2, bias2 / 2) : Json()}};
}

Json synthetic_statistics(const Json& study) {
    Json list = Json::array();
    const auto add = [&](Json entry) {
        for (const char* variant : {"fixed", "shipped"}) {
            for (const char* clock : {"cpu", "wall"}) {
                entry["variant"] = variant;
                entry["clock"] = clock;
                list.push_back(entry);
            }
        }
    };
    for (const std::string scene : study.at("scenes")) {
        for (const SyntheticMethod& method : kMethods) {
            for (const double budget_s : study.at("budgets_s"))
                add(statistics_of(scene, method, budget_s));
        }
    }
    return list;
}

void write_images(const fs::path& study, const SyntheticMethod& method) {
    const NamedLayer image{"", picture(method.brightness)};
    write_layers(study / image_name(kNastyScene, method, 0), {image});
    if (method.layers == 0) return;
    for (std::size_t time = 0; time < std::size(kTimes); ++time) {
        std::vector<NamedLayer> layers{image};
        for (std::size_t i = 0; i < method.layers; ++i)
            layers.push_back({kLayers[i], layer_map(kLayers[i], time)});
        write_layers(study / image_name(kPlainScene, method, time), layers);
    }
}

Json synthetic_runs(const fs::path& study) {
    Json runs = Json::array();
    for (const SyntheticMethod& method : kMethods) {
        write_images(study, method);
        for (const char* scene : {kPlainScene, kNastyScene}) {
            for (const char* variant : {"fixed", "shipped"}) {
                for (const int seed : {1, 2})
                    runs.push_back(run_of(scene, method, variant, seed));
            }
        }
    }
    return runs;
}

}  // namespace

Json write_synthetic_study(const fs::path& folder) {
    const Json study = study_settings();
    const Json runs = synthetic_runs(folder / "study");
    Json methods = Json::array(), scenes = Json::array();
    for (const SyntheticMethod& method : kMethods) {
        methods.push_back({{"name", method.name},
                           {"description", "A power law."},
                           {"integrator", method.name},
                           {"has_variants", true}});
    }
    for (const char* scene : {kPlainScene, kNastyScene})
        scenes.push_back(scene_facts(folder / "references", scene));
    Json summary{{"schema", kSummarySchema},
                 {"created", "2026-01-01T00:00:00Z"},
                 {"revisions", {"0123456789ab"}},
                 {"machine", runs.front().at("machine")},
                 {"study", study},
                 {"scenes", scenes},
                 {"methods", methods},
                 {"runs", runs},
                 {"seed_statistics", synthetic_statistics(study)},
                 {"comparisons", compare_methods(runs, study)}};
    write_json(folder / "study/summary.json", summary);
    return summary;
}

}  // namespace bench::test
