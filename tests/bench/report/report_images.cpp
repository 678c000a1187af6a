// Pictures of a report: crops of what methods have after equal time, and their signed errors.
#include "report_images.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include "crop_choice.h"
#include "image_file.h"
#include "report_curves.h"
#include "run_group.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
/// Of a noisy picture: 8-bit RGB that hardly compresses, in base64.
constexpr double kBytesPerPixel = 4;
constexpr double kErrorPercentile = 0.95;

/// The image of a method after the time that pictures are compared at.
struct Tile {
    std::string variant, method;
    const Json* run = nullptr;
    const Json* snapshot = nullptr;
    Image image;
    std::vector<float> differences;  ///< in the crop; empty without references
};

/// When pictures are compared.
struct Moment {
    std::string clock;
    double budget_s = 0;
    Json seed;
};

std::vector<Tile> find_tiles(const fs::path& folder, const Json& runs, const Json& study,
                             const std::string& scene, const Moment& moment) {
    std::vector<Tile> tiles;
    for (const Json& variant : study.at("variants")) {
        for (const Json& method : study.at("methods")) {
            const Json* run = find_run(runs, {scene, method, variant}, moment.seed);
            if (run == nullptr) continue;
            const auto index = snapshot_for(*run, moment.clock, moment.budget_s);
            if (!index) continue;
            const Json& snapshot = run->at("snapshots")[*index];
            const fs::path file = folder / snapshot.at("exr").get<std::string>();
            if (!fs::exists(file)) continue;
            tiles.push_back({variant, method, run, &snapshot, read_image(file), {}});
        }
    }
    return tiles;
}

/// Largest crop with which the pictures of the whole study take about `bytes`.
CropSize crop_size(const Json& study, double bytes) {
    const auto scenes = std::max(double(study.at("scenes").size()), 1.0);
    const double crops = 2 * double(study.at("variants").size() * study.at("methods").size()) + 1;
    const double pixels = bytes / kBytesPerPixel / scenes - kOverviewPixels;
    const int height = int(std::sqrt(std::max(pixels, 0.0) / crops * 3 / 4));
    return {std::clamp(height, 24, 144) * 4 / 3, std::clamp(height, 24, 144)};
}

/// Of all tiles' differences, up to a 1, 2 or 5 times a power of ten.
double error_scale(const std::vector<Tile>& tiles) {
    std::vector<double> sizes;
    for (const Tile& tile : tiles) {
        for (const float difference : tile.differences)
            sizes.push_back(std::abs(difference));
    }
    if (sizes.empty()) return 1;
    const auto nth = sizes.begin() + std::ptrdiff_t(kErrorPercentile * double(sizes.size() - 1));
    std::nth_element(sizes.begin(), nth, sizes.end());
    if (*nth <= 0) return 1;
    const double power = std::pow(10, std::floor(std::log10(*nth)));
    for (const double step : {1, 2, 5}) {
        if (*nth <= step * power) return step * power;
    }
    return 10 * power;
}

Json relmse_of(const Json& snapshot) {
    const Json& error = snapshot.at("error");
    return error.is_null() || error.at("image").is_null() ? Json() : error.at("image").at("relmse");
}

Json tile_entry(const Tile& tile, const Json& scene, const ToneMap& map, const Crop& crop,
                const std::string& clock) {
    const Json& scale = scene.at("error_scale");
    return {
        {"variant", tile.variant},
        {"method", tile.method},
        {"image", png_data_uri(tone_map(tile.image, map, crop))},
        {"error", scale.is_null()
                      ? Json()
                      : Json(png_data_uri(error_map(tile.differences, scale.get<double>(), crop)))},
        {"seconds", tile.snapshot->at(clock + "_s")},
        {"passes", tile.snapshot->at("pass")},
        {"relmse", relmse_of(*tile.snapshot)}};
}

Json to_json(const Crop& crop) {
    return {
        {"x", crop.x}, {"y", crop.y}, {"width_px", crop.width_px}, {"height_px", crop.height_px}};
}

bool fits(const Image& image, const Image& other) {
    return image.spec().width == other.spec().width && image.spec().height == other.spec().height;
}

const References* references_of(const Tile& tile, const std::string& scene, ReferenceCache& cache) {
    const Json& settings = tile.run->at("settings");
    return cache.find(scene, settings.at("scene_sha1"), settings.at("width_px"));
}

/// Less noisy than either.
Image mean_reference(const References& references) {
    const auto& [first, second] = references.image;
    return OIIO::ImageBufAlgo::mul(OIIO::ImageBufAlgo::add(first, second), 0.5F);
}

Json scene_entry(const std::string& name, std::vector<Tile>& tiles, const References* references,
                 const Moment& moment, const CropSize& size) {
    // Without references the first method's image stands for the truth in choosing what to show.
    const Image truth = references != nullptr ? mean_reference(*references) : tiles.front().image;
    for (const Tile& tile : tiles) {
        if (!fits(tile.image, truth))
            throw StudyError("images of scene \"" + name + "\" differ in size");
    }
    const ToneMap map{automatic_exposure(truth)};
    std::vector<const Image*> images;
    images.reserve(tiles.size());
    for (const Tile& tile : tiles)
        images.push_back(&tile.image);
    const Crop crop = choose_crop(images, truth, map, size);
    Json scene{{"scene", name},          {"exposure", map.exposure},    {"gamma", map.gamma},
               {"clock", moment.clock},  {"budget_s", moment.budget_s}, {"seed", moment.seed},
               {"crop", to_json(crop)},  {"overview", nullptr},         {"reference", nullptr},
               {"error_scale", nullptr}, {"tiles", Json::array()}};
    if (references != nullptr) {
        const auto& [first, second] = references->image;
        for (Tile& tile : tiles)
            tile.differences = relative_difference(tile.image, first, second, crop);
        scene["overview"] = png_data_uri(overview(truth, map));
        scene["reference"] = png_data_uri(tone_map(truth, map, crop));
        scene["error_scale"] = error_scale(tiles);
    }
    for (const Tile& tile : tiles)
        scene["tiles"].push_back(tile_entry(tile, scene, map, crop, moment.clock));
    return scene;
}

}  // namespace

Json report_images(const fs::path& folder, const Json& runs, const Json& study,
                   ReferenceCache& cache, double bytes) {
    Json list = Json::array();
    const Json& budgets = study.at("budgets_s");
    if (budgets.empty() || study.at("seeds").empty()) return list;
    const Moment moment{clocks_of(study).front(), budgets.back(), study.at("seeds").front()};
    const CropSize size = crop_size(study, bytes);
    for (const std::string scene : study.at("scenes")) {
        std::vector<Tile> tiles = find_tiles(folder, runs, study, scene, moment);
        if (tiles.empty()) continue;
        const References* references = references_of(tiles.front(), scene, cache);
        list.push_back(scene_entry(scene, tiles, references, moment, size));
    }
    return list;
}

}  // namespace bench
