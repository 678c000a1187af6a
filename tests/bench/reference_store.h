// Reference images on disk: two independent ones for each scene and width, and what is known of
// them.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "study_file.h"
#include "weighted_image.h"

namespace bench {

inline constexpr const char* kReferenceSchema = "aips-bench-reference-1";
/// Names of the two independent references, and of the one that shows the radius' bias.
inline constexpr std::array<const char*, 2> kReferenceNames{"1", "2"};
inline constexpr const char* kHalvedName = "halved";

/// Images of one part (the whole image or what photons carry) of both references.
struct ReferencePair {
    Image first, second;
};

/// What errors are measured against.
struct References {
    Json metadata;  ///< reference.json
    ReferencePair image;
    std::optional<ReferencePair> photons;  ///< if both have the layers

    /// SHA-1 of the two files by name.
    Json checksums() const;
};

/// Folder of a scene's references below `root`: SCENE, SCENE-wWIDTH for a width of its own, or
/// SCENE-wWIDTHxHEIGHT.
std::filesystem::path reference_folder(const std::filesystem::path& root, const std::string& scene,
                                       std::uint32_t width_px, std::uint32_t height_px = 0);

/// reference.json of that folder, new if there is none. Throws StudyError if the references are of
/// another version of the scene.
Json read_reference_metadata(const std::filesystem::path& folder, const std::string& scene,
                             const std::string& scene_sha1, std::uint32_t width_px,
                             std::uint32_t height_px = 0);

/// The whole image and, if there is one, the photon part of a reference as it grows.
struct GrowingReference {
    WeightedImage image;
    std::optional<WeightedImage> photons;
};

/// Image `name` of a folder. Throws StudyError if the file is not the one that the metadata speaks
/// of.
GrowingReference read_reference(const std::filesystem::path& folder, const Json& metadata,
                                const std::string& name);

/// The image merged with one more chunk; a photon part stays only if both have one.
GrowingReference merge(const GrowingReference& reference, const GrowingReference& chunk);

/// Writes the image; returns its SHA-1.
std::string write_reference(const std::filesystem::path& file, const GrowingReference& reference);

/// Both references of a scene, ready to measure with; nothing if one is missing. Throws StudyError
/// as the functions above.
std::optional<References> load_references(const std::filesystem::path& root,
                                          const std::string& scene, const std::string& scene_sha1,
                                          std::uint32_t width_px, std::uint32_t height_px = 0);

}  // namespace bench
