// Reference images on disk: two independent ones for each scene and width, and what is known of
// them.
#include "reference_store.h"

#include <fmt/format.h>

#include "checksum.h"
#include "image_file.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
constexpr const char* kErrorLayer = "standard_error";
constexpr const char* kPhotonErrorLayer = "photons_standard_error";

std::optional<WeightedImage> read_weighted(const fs::path& file, const Json& facts,
                                           const char* layer, const char* error_layer) {
    const auto mean = read_layer(file, layer);
    const auto error = read_layer(file, error_layer);
    if (!mean || !error) return std::nullopt;
    return restore(*mean, *error, facts.at("weight"), facts.at("chunks").size());
}

}  // namespace

Json References::checksums() const {
    Json sums = Json::object();
    for (const char* name : kReferenceNames)
        sums[name] = metadata.at("images").at(name).at("sha1");
    return sums;
}

fs::path reference_folder(const fs::path& root, const std::string& scene, std::uint32_t width_px,
                          std::uint32_t height_px) {
    const std::string height = height_px > 0 ? fmt::format("x{}", height_px) : "";
    return root / (width_px > 0 ? fmt::format("{}-w{}{}", scene, width_px, height) : scene);
}

Json read_reference_metadata(const fs::path& folder, const std::string& scene,
                             const std::string& scene_sha1, std::uint32_t width_px,
                             std::uint32_t height_px) {
    const fs::path file = folder / "reference.json";
    if (!fs::exists(file)) {
        return {{"schema", kReferenceSchema}, {"scene", scene},         {"scene_sha1", scene_sha1},
                {"width_px", width_px},       {"height_px", height_px}, {"image", nullptr},
                {"images", Json::object()},   {"agreement", nullptr},   {"bias_left", nullptr}};
    }
    Json metadata = read_json(file, kReferenceSchema);
    if (metadata.at("scene_sha1") != scene_sha1) {
        throw StudyError(fmt::format(
            "the references in '{}' are of another version of scene \"{}\"; remove that folder to "
            "have them made again",
            folder.string(), scene));
    }
    return metadata;
}

GrowingReference read_reference(const fs::path& folder, const Json& metadata,
                                const std::string& name) {
    const Json& facts = metadata.at("images").at(name);
    const fs::path file = folder / facts.at("file").get<std::string>();
    if (sha1_of_file(file) != facts.at("sha1").get<std::string>()) {
        throw StudyError(fmt::format("'{}' is damaged: its SHA-1 is not the one in reference.json",
                                     file.string()));
    }
    auto image = read_weighted(file, facts, "", kErrorLayer);
    if (!image) throw StudyError(fmt::format("'{}' has no standard error", file.string()));
    return {*std::move(image), read_weighted(file, facts, kPhotonLayer, kPhotonErrorLayer)};
}

GrowingReference merge(const GrowingReference& reference, const GrowingReference& chunk) {
    GrowingReference both{merge(reference.image, chunk.image), std::nullopt};
    if (reference.photons && chunk.photons)
        both.photons = merge(*reference.photons, *chunk.photons);
    return both;
}

std::string write_reference(const fs::path& file, const GrowingReference& reference) {
    std::vector<NamedLayer> layers{{"", reference.image.mean},
                                   {kErrorLayer, standard_error(reference.image)}};
    if (reference.photons) {
        layers.push_back({kPhotonLayer, reference.photons->mean});
        layers.push_back({kPhotonErrorLayer, standard_error(*reference.photons)});
    }
    write_layers(file, layers);
    return sha1_of_file(file);
}

std::optional<References> load_references(const fs::path& root, const std::string& scene,
                                          const std::string& scene_sha1, std::uint32_t width_px,
                                          std::uint32_t height_px) {
    const fs::path folder = reference_folder(root, scene, width_px, height_px);
    References references;
    references.metadata = read_reference_metadata(folder, scene, scene_sha1, width_px, height_px);
    for (const char* name : kReferenceNames) {
        if (!references.metadata.at("images").contains(name)) return std::nullopt;
    }
    GrowingReference first = read_reference(folder, references.metadata, kReferenceNames[0]);
    GrowingReference second = read_reference(folder, references.metadata, kReferenceNames[1]);
    references.image = {std::move(first.image.mean), std::move(second.image.mean)};
    if (first.photons && second.photons) {
        references.photons = {std::move(first.photons->mean), std::move(second.photons->mean)};
    }
    return references;
}

}  // namespace bench
