// What an image file claims to hold, and whether its size and our limits allow it: a few bytes must
// not make anyone ask for gigabytes.
#pragma once

#include <cstdint>
#include <string>

namespace lxs {

/// Numbers as a file has them, whatever they are.
struct ImageClaim {
    std::int64_t width = 0, height = 0, layers = 1, channels = 1;
    /// 0: not in tiles.
    std::int64_t tile_width = 0, tile_height = 0, tile_layers = 1;
};

/// Largest width and height: where texture coordinates in single precision still tell 64 places
/// within a pixel.
constexpr std::int64_t kLargestSide = 1 << 17;
/// What OpenImageIO takes.
constexpr std::int64_t kMostChannels = 1024;
/// Numbers of an image that is read at once: 16 GB.
constexpr std::int64_t kMostValuesAtOnce = std::int64_t{1} << 32;

/// Throws std::runtime_error unless `claim`, tiles filled up, is an image of one layer within the
/// limits that a file of `file_bytes` can hold. An image of 4096 x 4096 pixels with four channels
/// is believed of any file; formats that write even colours in no room have such.
void check_claim(const ImageClaim& claim, std::uint64_t file_bytes);

/// The same of what stands in the header of `path`, for formats whose readers in OpenImageIO make
/// buffers as they open a file, or believe what they should not: OpenEXR, JPEG, JPEG 2000, WebP,
/// GIF, BMP, SGI and DDS. Also throws where such a header can't be read; other formats are left to
/// their readers.
void check_header(const std::string& path, std::uint64_t file_bytes);

}  // namespace lxs
