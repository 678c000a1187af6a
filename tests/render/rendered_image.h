// Renders a scene file with lxsrender and reads the image back.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "temporary_folder.h"

namespace render {

/// Linear radiance of an EXR, or other channels, row by row, three floats a pixel or as many.
struct Image {
    std::size_t width = 0, height = 0;
    std::vector<float> rgb;

    std::vector<double> luminance() const;
    /// Mean luminances of size x size blocks.
    std::vector<double> block_means(std::size_t size) const;
};

/// The image of an EXR. Throws std::runtime_error if the file can't be read.
Image read_image(const std::filesystem::path& file);

/// Writes an EXR of 32-bit floats; throws std::runtime_error if it can't be written.
void write_image(const Image& image, const std::filesystem::path& file);

/// The layer of channels LAYER.R, LAYER.G, LAYER.B; throws std::runtime_error if there is none.
Image read_layer(const std::filesystem::path& file, const std::string& layer);

/// These channels, one after the other in each pixel; throws std::runtime_error if one is missing.
Image read_channels(const std::filesystem::path& file, const std::vector<std::string>& channels);

/// A text of an EXR's header; throws std::runtime_error if there is none of the name.
std::string header_text(const std::filesystem::path& file, const std::string& name);

/// Names of all channels of an EXR; throws std::runtime_error if the file can't be read.
std::set<std::string> channel_names(const std::filesystem::path& file);

using Folder = files::TemporaryFolder;

/// Runs lxsrender on `scene` with more arguments, output in `folder`; throws std::runtime_error
/// with all it said unless it exits with 0.
Image render(const std::filesystem::path& scene, const std::string& arguments,
             const Folder& folder);

/// Copies a scene into `folder` with texts replaced; throws if a text isn't there.
std::filesystem::path edited_scene(
    const std::filesystem::path& scene, const Folder& folder,
    const std::vector<std::pair<std::string, std::string>>& replacements);

/// One of scenes/ at width x height pixels, with a link to scenes/meshes beside it.
std::filesystem::path small_scene(const std::string& name, const Folder& folder, int width,
                                  int height);

/// Standard output of a command; throws std::runtime_error unless it exits with 0.
std::string output_of(const std::string& command);

}  // namespace render
