// Images of a study on disk: what an EXR holds, by layer.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "error_metrics.h"
#include "pixel_map.h"

namespace bench {

/// Layer of the radiance that photons carry.
inline constexpr const char* kPhotonLayer = "photons";

/// Layers R, G, B of an EXR file, or LAYER.R, LAYER.G, LAYER.B; nothing if it has no such layer.
/// Throws StudyError if the file can't be read or the image itself (layer "") is missing.
std::optional<Image> read_layer(const std::filesystem::path& file, const std::string& layer);

/// Channel LAYER.Y, a layer of one number for each pixel; nothing if the file has no such layer.
/// Throws StudyError if the file can't be read.
std::optional<PixelMap> read_map(const std::filesystem::path& file, const std::string& layer);

/// The image itself.
Image read_image(const std::filesystem::path& file);

/// A layer to be written.
struct NamedLayer {
    std::string name;  ///< "" for the image itself
    /// Three channels, or one that becomes NAME.Y.
    Image image;
};

/// 32-bit floats, written beside and renamed. Throws lxs::OutputFailure.
void write_layers(const std::filesystem::path& file, const std::vector<NamedLayer>& layers);

}  // namespace bench
