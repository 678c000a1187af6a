// How much a case's images differ from seed to seed: its noise, without any reference.
#include "seed_variance.h"

#include <OpenImageIO/imagebufalgo.h>

#include <map>
#include <string>
#include <vector>

#include "experiment_errors.h"
#include "image_file.h"
#include "seed_statistics.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
namespace algo = OIIO::ImageBufAlgo;

/// Last snapshots of a case, one for each seed whose run was done.
std::vector<Image> last_images(const Experiment& experiment, const Json& runs,
                               const std::string& scene, const std::string& name, unsigned seeds,
                               const fs::path& study) {
    const std::string layer = experiment.part == "photons" ? kPhotonLayer : "";
    std::vector<Image> images;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        const Json* run = find_paper_run(runs, scene, name, seed);
        if (run == nullptr) continue;
        const fs::path file = study / run->at("snapshots").back().at("exr").get<std::string>();
        if (auto image = read_layer(file, layer)) images.push_back(*std::move(image));
    }
    return images;
}

/// Fills the row of the case whose images are `own`.
void compare(const std::vector<Image>& own, const std::vector<Image>& against, Json& row) {
    row["relative_variance"] = nullptr;
    row["variance_ratio"] = nullptr;
    if (own.size() < 2 || against.size() < 2) return;
    // Both weigh alike: a pixel in which one of them alone is bright counts the same for either.
    const Image mean = algo::mul(algo::add(mean_image(own), mean_image(against)), 0.5f);
    const double variance = seed_statistics(own, mean, mean).rel_variance;
    const double baseline = seed_statistics(against, mean, mean).rel_variance;
    row["relative_variance"] = variance;
    if (baseline > 0) row["variance_ratio"] = variance / baseline;
}

}  // namespace

void add_seed_variance(const Experiment& experiment, const Json& runs, unsigned seeds,
                       const fs::path& study, Json& scene) {
    std::map<std::string, std::vector<Image>> images;
    for (const PaperCase& one : experiment.cases) {
        images[one.name] = last_images(experiment, runs, scene.at("scene"), one.name, seeds, study);
    }
    for (Json& row : scene["rows"])
        compare(images[row.at("case")], images[row.at("against")], row);
}

}  // namespace bench
