// How much a case's images differ from seed to seed: its noise, without any reference.
#include "seed_variance.h"

#include <OpenImageIO/imagebufalgo.h>

#include <map>
#include <optional>
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

}  // namespace

void add_seed_variance(const Experiment& experiment, const Json& runs, unsigned seeds,
                       const fs::path& study, Json& scene) {
    std::map<std::string, std::vector<Image>> images;
    Image sum;
    float count = 0;
    for (const PaperCase& one : experiment.cases) {
        auto& own = images[one.name];
        own = last_images(experiment, runs, scene.at("scene"), one.name, seeds, study);
        for (const Image& image : own) {
            sum = sum.initialized() ? algo::add(sum, image) : image;
            ++count;
        }
    }
    std::map<std::string, double> variances;
    for (const auto& [name, own] : images) {
        if (own.size() < 2) continue;
        const Image mean = algo::mul(sum, 1 / count);
        variances[name] = seed_statistics(own, mean, mean).rel_variance;
    }
    for (Json& row : scene["rows"]) {
        const auto own = variances.find(row.at("case").get<std::string>());
        const auto against = variances.find(row.at("against").get<std::string>());
        const bool known = own != variances.end();
        const bool comparable = known && against != variances.end() && against->second > 0;
        row["relative_variance"] = known ? Json(own->second) : Json();
        row["variance_ratio"] = comparable ? Json(own->second / against->second) : Json();
    }
}

}  // namespace bench
