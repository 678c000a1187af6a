// Image files that others made: textures and maps of lights.
//
// OpenImageIO reads them. It brings some 250 shared libraries, whose loading takes 0.3 s: lxsrender
// loads it with the first image of a scene, and starts without it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "lxs/images/voxel_grid.h"
#include "lxs/spectrum/stored_curve.h"

namespace lxs {

/// An image as numbers: [row][column][channel], the top row first.
struct FloatImage {
    std::size_t width = 0, height = 0, channels = 0;
    std::vector<float> values;
};

/// How texels become values.
struct TexelLookup {
    enum class Outside : std::uint8_t { Repeat, Black, Clamp };
    Outside outside = Outside::Repeat;
    bool interpolated = true;  ///< bilinearly; else the nearest texel
};

/// An image made ready for lookups, from any thread. Its cache outlives it.
class CachedImage {
  public:
    virtual ~CachedImage() = default;
    virtual int channels() const = 0;
    virtual int alpha_channel() const = 0;  ///< -1: none
    /// Values of the file that were not finite or negative, in whose place 0 is used.
    virtual std::uint64_t refused() const = 0;
    /// Fills `values` with channels from `first` on at (s, t), [0, 1]^2 being the image. Throws
    /// std::runtime_error with the reason if the file can't be read any more.
    virtual void look_up(float s, float t, int first, const TexelLookup& how,
                         std::span<float> values) const = 0;
    /// The same image, whose texels but for alpha become linear before they are interpolated.
    virtual std::unique_ptr<const CachedImage> decoded(const StoredCurve& curve) const = 0;
};

/// Images that share memory. For any thread.
class CachedImages {
  public:
    virtual ~CachedImages() = default;
    /// Opens the file `path` and reads it once. Throws std::runtime_error with the reason if it
    /// can't be read.
    virtual std::unique_ptr<const CachedImage> open(const std::string& path) = 0;
};

class ImageLibrary {
  public:
    virtual ~ImageLibrary() = default;
    /// Throws std::runtime_error with the reason if the file can't be read.
    virtual FloatImage read(const std::string& path) const = 0;
    /// The grid called `name` of a volume file (OpenVDB or NanoVDB). Throws likewise.
    virtual VoxelGrid read_grid(const std::string& path, const std::string& name) const = 0;
    virtual std::unique_ptr<CachedImages> make_cache() const = 0;
};

/// An installation without the part that reads images.
class ImageLibraryFailure : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Loads it first, if need be; throws ImageLibraryFailure if that fails.
const ImageLibrary& image_library();

/// The shared object that it is loaded from; empty if there is none, or the program is linked with
/// the library.
std::filesystem::path image_library_file();

}  // namespace lxs
