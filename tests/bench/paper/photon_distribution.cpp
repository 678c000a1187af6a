// Fig. 6 and 7 of the paper: where photons land, over the passes, in numbers and pictures.
#include "photon_distribution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "error_metrics.h"
#include "experiment_errors.h"
#include "image_file.h"
#include "map_picture.h"
#include "pixel_map.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

constexpr double kRegionShare = 0.1;     ///< of the pixels: the brightest, and those at edges
constexpr int kBlocksAcross = 32;        ///< over the width of the image
constexpr double kWhiteQuantile = 0.99;  ///< density that pictures show as white

using Blocks = std::vector<double>;

/// What doesn't change from stage to stage.
struct SceneMaps {
    std::vector<bool> highlights, edges;
    Blocks error;  ///< of the unguided images at the end; radiance^2
    int block_px = 1;
};

/// A run's photon density in the passes after the snapshot before, up to a snapshot.
struct Stage {
    std::uint64_t first_pass = 1, last_pass = 1;
    PixelMap density;
    std::optional<Blocks> node_error;  ///< nothing without a guide
};

PixelMap difference(const PixelMap& later, std::uint64_t passes, const PixelMap& earlier,
                    std::uint64_t earlier_passes) {
    PixelMap map = later;
    const auto count = double(passes - earlier_passes);
    for (std::size_t i = 0; i < map.values.size(); ++i) {
        const double sum =
            later.values[i] * double(passes) - earlier.values[i] * double(earlier_passes);
        map.values[i] = std::max(0.0, sum / count);  // rounding of the image's floats
    }
    return map;
}

std::vector<Stage> stages_of(const fs::path& study, const Json* run, int block_px) {
    std::vector<Stage> stages;
    if (run == nullptr) return stages;
    PixelMap before;
    std::uint64_t passes_before = 0;
    for (const Json& snapshot : run->at("snapshots")) {
        const fs::path file = study / snapshot.at("exr").get<std::string>();
        const auto mean = read_map(file, "photondensity");
        if (!mean) throw StudyError("'" + file.string() + "' has no layer photondensity");
        const std::uint64_t passes = snapshot.at("pass");
        Stage stage{passes_before + 1, passes,
                    passes_before > 0 ? difference(*mean, passes, before, passes_before) : *mean,
                    std::nullopt};
        if (const auto error = read_map(file, "nodeerror"))
            stage.node_error = block_means(*error, block_px);
        stages.push_back(std::move(stage));
        before = *mean;
        passes_before = passes;
    }
    return stages;
}

SceneMaps scene_maps(const DistributionInput& input, const std::string& unguided) {
    const auto& [first, second] = input.references.image;
    PixelMap truth = luminance_map(first);
    const PixelMap other = luminance_map(second);
    for (std::size_t i = 0; i < truth.values.size(); ++i)
        truth.values[i] = (truth.values[i] + other.values[i]) / 2;
    SceneMaps maps;
    maps.block_px = std::max(1, truth.width_px / kBlocksAcross);
    maps.highlights = largest_pixels(truth, kRegionShare);
    const double floor = std::sqrt(relative_epsilon(first, second));
    for (double& value : truth.values)
        value = std::log(std::max(value, 0.0) + floor);
    maps.edges = largest_pixels(gradient_magnitude(truth), kRegionShare);
    for (unsigned seed = 1; seed <= input.seeds; ++seed) {
        const Json* run = find_paper_run(input.runs, input.scene, unguided, seed);
        if (run == nullptr) continue;
        const fs::path file =
            input.study / run->at("snapshots").back().at("exr").get<std::string>();
        const Image product = error_product(read_image(file), first, second);
        const Blocks error = block_means(luminance_map(product), maps.block_px);
        maps.error.resize(error.size());
        for (std::size_t i = 0; i < error.size(); ++i)
            maps.error[i] += error[i];
    }
    return maps;
}

/// log of the ratio of both densities, each divided by its own sum; nothing where one is black.
std::optional<Blocks> added_density(const Blocks& density, const Blocks& unguided) {
    double sum = 0, unguided_sum = 0;
    for (std::size_t i = 0; i < density.size(); ++i) {
        sum += density[i];
        unguided_sum += unguided[i];
    }
    if (!(sum > 0 && unguided_sum > 0)) return std::nullopt;
    Blocks added(density.size());
    // A block without photons counts as one with a thousandth of the mean.
    const double floor = 1e-3 / double(density.size());
    for (std::size_t i = 0; i < density.size(); ++i)
        added[i] = std::log((density[i] / sum + floor) / (unguided[i] / unguided_sum + floor));
    return added;
}

using Figures = std::map<std::string, std::optional<double>>;

/// `unguided` is the stage of the unguided run with the same seed, `other` that of another seed if
/// `stage` is itself unguided.
Figures figures_of(const SceneMaps& maps, const Stage& stage, const Stage& unguided,
                   const Stage* other) {
    const Blocks density = block_means(stage.density, maps.block_px);
    const Blocks plain = block_means(unguided.density, maps.block_px);
    Figures figures;
    figures["highlight_share"] = share_within(stage.density, maps.highlights);
    figures["edge_share"] = share_within(stage.density, maps.edges);
    figures["unevenness"] = unevenness(density);
    figures["error_correlation"] = rank_correlation(density, maps.error);
    const bool is_unguided = &stage == &unguided;
    if (!is_unguided) {
        const std::optional<Blocks> added = added_density(density, plain);
        figures["distance"] = distribution_distance(density, plain);
        if (added) figures["added_error_correlation"] = rank_correlation(*added, maps.error);
        if (added && stage.node_error)
            figures["added_node_error_correlation"] = rank_correlation(*added, *stage.node_error);
    } else if (other != nullptr) {
        figures["distance"] =
            distribution_distance(density, block_means(other->density, maps.block_px));
    }
    return figures;
}

Json mean_of(const std::vector<Figures>& seeds, const char* name) {
    double sum = 0, count = 0;
    for (const Figures& figures : seeds) {
        const auto found = figures.find(name);
        if (found == figures.end() || !found->second) continue;
        sum += *found->second;
        ++count;
    }
    return count > 0 ? Json(sum / count) : Json();
}

/// Stages by seed; empty for a run that failed.
using SeedStages = std::vector<std::vector<Stage>>;

SeedStages all_stages(const DistributionInput& input, const std::string& name, int block_px) {
    SeedStages stages;
    for (unsigned seed = 1; seed <= input.seeds; ++seed) {
        stages.push_back(
            stages_of(input.study, find_paper_run(input.runs, input.scene, name, seed), block_px));
    }
    return stages;
}

Json stage_document(const SceneMaps& maps, const SeedStages& seeds, const SeedStages& unguided,
                    std::size_t index) {
    std::vector<Figures> figures;
    const Stage* shown = nullptr;
    for (std::size_t seed = 0; seed < seeds.size(); ++seed) {
        if (seeds[seed].size() <= index || unguided[seed].size() <= index) continue;
        const auto& another = unguided[(seed + 1) % unguided.size()];
        const bool has_other = unguided.size() > 1 && another.size() > index;
        shown = &seeds[seed][index];
        figures.push_back(
            figures_of(maps, *shown, unguided[seed][index], has_other ? &another[index] : nullptr));
    }
    Json stage = Json::object();
    if (shown == nullptr) return stage;
    stage = {{"first_pass", shown->first_pass}, {"last_pass", shown->last_pass}};
    for (const char* name :
         {"highlight_share", "edge_share", "unevenness", "distance", "error_correlation",
          "added_error_correlation", "added_node_error_correlation"})
        stage[name] = mean_of(figures, name);
    return stage;
}

void write_pictures(const DistributionInput& input, const std::string& name,
                    const std::vector<Stage>& stages, double white) {
    for (const Stage& stage : stages) {
        write_picture(input.images / fmt::format("{}.{}.passes-{}-{}.png", input.scene, name,
                                                 stage.first_pass, stage.last_pass),
                      stage.density, white);
    }
}

}  // namespace

Json photon_distribution(const DistributionInput& input) {
    const std::string unguided_name = input.experiment.cases.front().against;
    const SceneMaps maps = scene_maps(input, unguided_name);
    const SeedStages unguided = all_stages(input, unguided_name, maps.block_px);
    const double white = unguided.front().empty()
                             ? 0
                             : quantile(unguided.front().back().density.values, kWhiteQuantile);
    Json rows = Json::array();
    for (const PaperCase& one : input.experiment.cases) {
        const bool is_unguided = one.name == unguided_name;
        const SeedStages guided =
            is_unguided ? SeedStages() : all_stages(input, one.name, maps.block_px);
        const SeedStages& stages = is_unguided ? unguided : guided;
        Json list = Json::array();
        for (std::size_t i = 0; i < stages.front().size(); ++i)
            list.push_back(stage_document(maps, stages, unguided, i));
        write_pictures(input, one.name, stages.front(), white);
        rows.push_back({{"case", one.name}, {"label", one.label}, {"stages", std::move(list)}});
    }
    return {{"scene", input.scene}, {"block_px", maps.block_px}, {"rows", std::move(rows)}};
}

}  // namespace bench
