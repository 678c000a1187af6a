// Samples of block means for tests of agreement: a method's runs, and a scene's references.
#include "agreement_samples.h"

#include <fmt/format.h>

#include "image_file.h"
#include "method_table.h"
#include "reference_checks.h"
#include "run_errors.h"

namespace bench {
namespace {

/// The group's runs that are done, by `action`(run).
template <class Action>
void for_each_run(const Json& summary, const RunGroup& group, const Action& action) {
    for (const Json& seed : summary.at("study").at("seeds")) {
        const Json* run = find_run(summary.at("runs"), group, seed);
        if (run != nullptr && run->at("status") == "done") action(*run);
    }
}

/// Share of each chunk of an image in the sample, by `action`(image, chunk, weight): images weigh
/// as their work does where one method made both, else alike.
template <class Action>
void for_each_chunk(const Json& metadata, const Action& action) {
    const Json& images = metadata.at("images");
    const bool same_unit =
        images.at(kReferenceNames[0]).at("set") == images.at(kReferenceNames[1]).at("set");
    for (const char* name : kReferenceNames) {
        const Json& image = images.at(name);
        const double unit = same_unit ? 1 : image.at("weight").get<double>();
        for (const Json& chunk : image.at("chunks"))
            action(image, chunk, chunk.at("weight").get<double>() / unit);
    }
}

/// Whether the last "alpha" among overrides is 1, and radii are not the visible points' own.
bool keeps_its_radius(const Json& set) {
    bool keeps = false;
    for (const std::string text : set) {
        if (text.find(".alpha=") != std::string::npos) keeps = text.ends_with(".alpha=1");
        if (text.ends_with(".radius=adaptive")) return false;
    }
    return keeps;
}

}  // namespace

SeedBlocks blocks_of_runs(const std::filesystem::path& folder, const Json& summary,
                          const RunGroup& group) {
    const Json& study = summary.at("study");
    const std::string clock = study.at("clock") == "wall" ? "wall" : "cpu";
    const double budget_s = study.at("budgets_s").back();
    SeedBlocks blocks;
    for_each_run(summary, group, [&](const Json& run) {
        const auto index = snapshot_for(run, clock, budget_s);
        if (!index) return;
        const std::string file = run.at("snapshots")[*index].at("exr");
        blocks[run.at("settings").at("seed")] = block_luminances(read_image(folder / file));
    });
    return blocks;
}

std::optional<double> radius_of_runs(const Json& summary, const RunGroup& group) {
    std::optional<double> radius;
    for_each_run(summary, group, [&](const Json& run) {
        const Json& set = run.at("settings").at("set");
        const auto found = startradius(set.get<std::vector<std::string>>());
        if (!found) return;
        if (!keeps_its_radius(set) || (radius && radius != found)) {
            throw StudyError(fmt::format("runs of \"{}\" on \"{}\" have not one fixed radius",
                                         group.method, group.scene));
        }
        radius = found;
    });
    return radius;
}

BlockSample blocks_of_references(const Json& metadata) {
    BlockSample sample;
    for (const char* name : kReferenceNames) {
        for (auto& blocks : chunk_blocks(metadata.at("images").at(name).at("chunks")))
            sample.means.push_back(std::move(blocks));
    }
    for_each_chunk(metadata, [&](const Json&, const Json&, double weight) {
        sample.weights.push_back(weight);
    });
    return sample;
}

BiasFactors reference_radii(const Json& metadata) {
    BiasFactors sum;
    double weights = 0;
    for_each_chunk(metadata, [&](const Json& image, const Json&, double weight) {
        const Json& footprints = image.at("startradius_footprints");
        const double radius = footprints.is_number() ? footprints.get<double>() : 0;
        sum.quadratic += weight * radius * radius;
        sum.linear += weight * radius;
        weights += weight;
    });
    return {sum.quadratic / weights, sum.linear / weights};
}

}  // namespace bench
