// `aips-bench reference`: renders more of a scene's reference images and merges it into them.
#include "reference_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "image_file.h"
#include "method_check.h"
#include "photon_part.h"
#include "reference_checks.h"
#include "reference_store.h"
#include "render_process.h"
#include "run_record.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

/// Chunks that one command adds to each image; standard errors and comparisons need several.
constexpr int kChunks = 4;
constexpr double kShortestChunk = 0.2;  ///< seconds
/// Seeds of image i begin at (i + 1) times this, apart from those of runs.
constexpr std::uint64_t kSeedsOfAnImage = 1'000'000;

/// Renders the image that shows the bias left.
constexpr const char* kHalvedMethod = "photons-halved";

/// One of the images of a scene that are to grow.
struct ReferenceImage {
    std::string name;
    const Method* method = nullptr;
    std::vector<std::string> set = {};
    std::uint64_t first_seed = 0;
    double chunk_seconds = 0;
};

/// A scene's references while they grow.
struct Folder {
    fs::path path;
    Json metadata;
};

std::vector<ReferenceImage> images_of(const BenchScene& scene, const MethodTable& table,
                                      const lxs::PluginLibrary& plugins) {
    std::vector<ReferenceImage> images;
    for (std::size_t i = 0; i < scene.references.size(); ++i) {
        images.push_back({kReferenceNames[i], &find_method(table.references, scene.references[i])});
    }
    const auto needs_radius = [&](const ReferenceImage& image) {
        return startradius(overrides(table, *image.method, kAny, {})).has_value();
    };
    if (std::all_of(images.begin(), images.end(), needs_radius)) {
        images.push_back({kHalvedName, &find_method(table.references, kHalvedMethod)});
    }
    for (std::size_t i = 0; i < images.size(); ++i) {
        images[i].set = overrides(table, *images[i].method, kAny, {});
        add_photon_part(images[i].method->integrator, plugins, images[i].set);
        images[i].first_seed = (i + 1) * kSeedsOfAnImage;
    }
    return images;
}

double seconds_so_far(const Json& metadata, const std::string& clock) {
    double sum = 0;
    for (const Json& image : metadata.at("images"))
        sum += image.at(clock + "_s").get<double>();
    return sum;
}

RenderJob chunk_job(const ReferenceRequest& request, const BenchScene& scene,
                    const ReferenceImage& image, std::uint64_t seed, const fs::path& folder) {
    RenderJob job;
    job.settings.scene = scene.name;
    job.settings.scene_file = scene.file.string();
    job.settings.width_px = request.width_px;
    job.settings.height_px = request.height_px;
    job.settings.method = image.method->name;
    job.settings.variant = kAny;
    job.settings.integrator = image.method->integrator;
    job.settings.sampler = image.method->sampler;
    job.settings.set = image.set;
    job.settings.seed = seed;
    job.settings.threads = request.threads;
    job.settings.budgets_s = {image.chunk_seconds};
    job.settings.clock = request.clock;
    job.images = (folder / "chunk").string();
    job.final_only = true;
    job.result = (folder / "chunk.json").string();
    return job;
}

Json new_image(const ReferenceImage& image) {
    const auto radius = startradius(image.set);
    return {{"file", ""},
            {"sha1", ""},
            {"method", image.method->name},
            {"integrator", image.method->integrator},
            {"set", image.set},
            {"startradius_footprints", radius ? Json(*radius) : Json()},
            {"weight", 0.0},
            {"photon_paths", 0},
            {"samples_per_pixel", 0.0},
            {"passes", 0},
            {"wall_s", 0.0},
            {"cpu_s", 0.0},
            {"has_photon_layers", false},
            {"standard_error", nullptr},
            {"radius", nullptr},
            {"chunks", Json::array()}};
}

/// Work in a chunk.
double weight_of(const Json& totals) {
    const double paths = totals.at("photon_paths");
    return paths > 0 ? paths : totals.at("samples_per_pixel").get<double>();
}

template <class Number>
void add_to(Json& sum, const Json& more) {
    sum = sum.get<Number>() + more.get<Number>();
}

void count_chunk(Json& facts, const Json& measured, std::uint64_t seed, const Image& image,
                 const std::string& revision) {
    const Json& totals = measured.at("totals");
    add_to<std::uint64_t>(facts["photon_paths"], totals.at("photon_paths"));
    add_to<double>(facts["samples_per_pixel"], totals.at("samples_per_pixel"));
    add_to<std::uint64_t>(facts["passes"], totals.at("passes"));
    add_to<double>(facts["wall_s"], measured.at("phases").at("render_wall_s"));
    add_to<double>(facts["cpu_s"], measured.at("phases").at("render_cpu_s"));
    facts["radius"] = measured.at("integrator_statistics").value("radius", Json());
    facts["chunks"].push_back({{"seed", seed},
                               {"weight", weight_of(totals)},
                               {"passes", totals.at("passes")},
                               {"wall_s", measured.at("phases").at("render_wall_s")},
                               {"revision", revision},
                               {"blocks", block_luminances(image)}});
}

GrowingReference read_chunk(const fs::path& file, double weight) {
    GrowingReference chunk{one_chunk(read_image(file), weight), std::nullopt};
    if (const auto photons = read_layer(file, kPhotonLayer)) {
        chunk.photons = one_chunk(*photons, weight);
    }
    return chunk;
}

/// Puts a rendered chunk into the image and its metadata. The new file has a new name, so that the
/// folder is whole at every moment.
void merge_chunk(Folder& folder, const ReferenceImage& image, const Json& measured,
                 std::uint64_t seed, const std::string& revision) {
    Json facts = folder.metadata["images"].value(image.name, new_image(image));
    if (facts["method"] != image.method->name || facts["set"] != Json(image.set)) {
        throw StudyError(
            fmt::format("image {} in '{}' was made with other settings; remove that "
                        "folder to have it made again",
                        image.name, folder.path.string()));
    }
    const fs::path chunk_file = measured.at("snapshots").back().at("exr").get<std::string>();
    GrowingReference grown = read_chunk(chunk_file, weight_of(measured.at("totals")));
    count_chunk(facts, measured, seed, grown.image.mean, revision);
    const std::string old_file = facts["file"];
    if (!old_file.empty())
        grown = merge(read_reference(folder.path, folder.metadata, image.name), grown);
    facts["file"] = fmt::format("{}.{}.exr", image.name, grown.image.chunks);
    facts["sha1"] = write_reference(folder.path / facts["file"].get<std::string>(), grown);
    facts["weight"] = grown.image.weight;
    facts["has_photon_layers"] = grown.photons.has_value();
    facts["standard_error"] = relative_standard_error(grown.image);
    folder.metadata["images"][image.name] = facts;
    folder.metadata["image"] = measured.at("image");
    write_json(folder.path / "reference.json", folder.metadata);
    std::error_code ignored;
    if (!old_file.empty()) fs::remove(folder.path / old_file, ignored);
    fs::remove(chunk_file, ignored);
}

/// False if it was interrupted.
bool render_chunk(const ReferenceRequest& request, const BenchScene& scene, Folder& folder,
                  const ReferenceImage& image, const Build& build) {
    const Json& images = folder.metadata.at("images");
    const std::size_t done =
        images.contains(image.name) ? images.at(image.name).at("chunks").size() : 0;
    const std::uint64_t seed = image.first_seed + done;
    const RenderJob job = chunk_job(request, scene, image, seed, folder.path);
    const ProcessEnd end = render_in_process(own_executable(), job, folder.path / "chunk.log");
    if (end.interrupted) return false;
    if (!end.done) {
        throw StudyError(fmt::format("reference {} of \"{}\" can't be rendered: {}", image.name,
                                     scene.name, end.message));
    }
    merge_chunk(folder, image, read_json(job.result), seed, build.revision);
    std::error_code ignored;
    fs::remove(job.result, ignored);
    return true;
}

void check_references(Folder& folder) {
    Json& metadata = folder.metadata;
    metadata["agreement"] = agreement(metadata["images"]);
    if (metadata["images"].contains(kHalvedName)) {
        const auto first = read_reference(folder.path, metadata, kReferenceNames[0]);
        const auto second = read_reference(folder.path, metadata, kReferenceNames[1]);
        const auto halved = read_reference(folder.path, metadata, kHalvedName);
        metadata["bias_left"] = bias_left({first.image.mean, second.image.mean}, halved.image);
    }
    write_json(folder.path / "reference.json", metadata);
}

void report(const Folder& folder, const std::string& scene, lxs::ConsoleLog& log) {
    for (const auto& [name, image] : folder.metadata["images"].items()) {
        log.info(fmt::format("{}: reference {} ({}): {} chunks, {:.1f} s, standard error {}", scene,
                             name, image["method"].get<std::string>(), image["chunks"].size(),
                             image["wall_s"].get<double>(), image["standard_error"].dump()));
    }
    if (!folder.metadata["bias_left"].is_null()) {
        log.info(fmt::format("{}: bias left {}", scene, folder.metadata["bias_left"].dump()));
    }
}

/// False if it was interrupted.
bool grow(const ReferenceRequest& request, const BenchScene& scene,
          std::vector<ReferenceImage> images, Folder& folder, const lxs::Interruption& interruption,
          lxs::ConsoleLog& log) {
    const double gone = request.up_to ? seconds_so_far(folder.metadata, request.clock) : 0;
    const double seconds = request.seconds - gone;
    const double shortest_round = kShortestChunk * double(images.size());
    // A remainder that is shorter than a round of chunks is not worth its loading time.
    if (request.up_to && seconds < shortest_round) return true;
    const int rounds = std::clamp(int(seconds / shortest_round), 1, kChunks);
    const Build build = this_build();
    for (int round = 0; round < rounds; ++round) {
        for (ReferenceImage& image : images) {
            image.chunk_seconds = seconds / double(images.size()) / rounds;
            if (interruption.requested() || !render_chunk(request, scene, folder, image, build)) {
                return false;
            }
        }
        log.info(fmt::format("{}: chunk {} of {}", scene.name, round + 1, rounds));
    }
    check_references(folder);
    return true;
}

}  // namespace

ExitCode make_references(const ReferenceRequest& request, const MethodTable& table,
                         const lxs::PluginLibrary& plugins, const lxs::Interruption& interruption,
                         lxs::ConsoleLog& log) {
    ExitCode code = ExitCode::Success;
    for (const BenchScene& scene : request.scenes) {
        const auto images = images_of(scene, table, plugins);
        Folder folder{
            reference_folder(request.root, scene.name, request.width_px, request.height_px), {}};
        folder.metadata =
            read_reference_metadata(folder.path, scene.name, scene_checksum(scene.file),
                                    request.width_px, request.height_px);
        for (const ReferenceImage& image : images)
            check_method(*image.method, image.set, plugins, folder.path, log);
        if (!grow(request, scene, images, folder, interruption, log)) return ExitCode::Interrupted;
        report(folder, scene.name, log);
        const Json& agreement = folder.metadata["agreement"];
        if (!agreement.is_null() && !agreement.at("agree").get<bool>()) {
            log.warning(
                fmt::format("{}: the two references differ: {}", scene.name, agreement.dump()));
            code = ExitCode::ReferencesDiffer;
        }
    }
    return code;
}

}  // namespace bench
