// Small image files of every format that is read, good ones and ones that claim what they don't
// hold.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lxs::test {

struct MadeImage {
    std::string name, bytes;
};

/// What a header says.
struct MadeSizes {
    std::uint32_t width = 8, height = 4, layers = 1, channels = 3;
    std::uint32_t tile_width = 0, tile_height = 0, tile_layers = 0;  ///< 0: the header has none
};

/// Files of 8 x 4 pixels or some more, one of each format and kind: rows, tiles, compressions, a
/// cube map, a volume, tiles of several layers. The last two are no pictures.
std::vector<MadeImage> small_images();
constexpr std::size_t kNoPictures = 2;  ///< at the end of small_images()

/// A header, and some hundred bytes in place of the pixels.
std::string made_bmp(const MadeSizes& sizes);  ///< run lengths
std::string made_dds(const MadeSizes& sizes);  ///< six faces where `tile_layers` is 6
std::string made_exr(const MadeSizes& sizes, const std::string& more_attributes = "");
std::string made_gif(const MadeSizes& sizes);
std::string made_hdr(const MadeSizes& sizes);
std::string made_jpeg(const MadeSizes& sizes);  ///< progressive
std::string made_jpeg_2000(const MadeSizes& sizes, bool in_boxes);
std::string made_pnm(const MadeSizes& sizes);
std::string made_sgi(const MadeSizes& sizes);  ///< run lengths
std::string made_tga(const MadeSizes& sizes);
std::string made_tiff(const MadeSizes& sizes);
std::string made_webp(const MadeSizes& sizes);

/// An attribute of an OpenEXR header that says to have `size` bytes.
std::string exr_attribute(const std::string& name, const std::string& type, std::uint32_t size,
                          const std::string& value);

}  // namespace lxs::test
