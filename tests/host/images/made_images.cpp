// Headers of image formats, byte by byte, and files that OpenImageIO writes.
#include "made_images.h"

#include <OpenImageIO/imageio.h>

#include <stdexcept>

#include "temporary_folder.h"

namespace lxs::test {
namespace {

std::string little(std::uint64_t number, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i)
        text += static_cast<char>(number >> (8 * i));
    return text;
}

std::string big(std::uint64_t number, int bytes) {
    const std::string text = little(number, bytes);
    return {text.rbegin(), text.rend()};
}

std::string zeros(std::size_t count) {
    return std::string(count, '\0');
}

/// A file that OpenImageIO writes: `name` says the format, `spec` the rest.
MadeImage written(const std::string& name, OIIO::ImageSpec spec) {
    const files::TemporaryFolder folder;
    const std::string path = folder / name;
    std::vector<float> values(spec.image_pixels() * spec.nchannels);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(i % 7) / 8;
    const auto file = OIIO::ImageOutput::create(path);
    if (!file || !file->open(path, spec) ||
        !file->write_image(OIIO::TypeDesc::FLOAT, values.data()) || !file->close())
        throw std::runtime_error("can't write " + name);
    return {name, folder.read(name)};
}

MadeImage written(const std::string& name, const char* key = nullptr, const char* value = "",
                  int tile = 0, OIIO::TypeDesc type = OIIO::TypeDesc::UINT8, int channels = 3) {
    OIIO::ImageSpec spec(8, 4, channels, type);
    spec.tile_width = spec.tile_height = tile;
    if (key) spec.attribute(key, value);
    return written(name, spec);
}

}  // namespace

std::string made_bmp(const MadeSizes& sizes) {
    return "BM" + little(200, 4) + zeros(4) + little(54 + 1024, 4) + little(40, 4) +
           little(sizes.width, 4) + little(sizes.height, 4) + little(1, 2) + little(8, 2) +
           little(1, 4) + zeros(12) + little(256, 4) + zeros(4) + zeros(1024) + "\x08\x01" +
           zeros(2) + "\x08\x02" + zeros(2) + "\x08\x03" + zeros(2) + "\x08\x04" + zeros(1) +
           "\x01";
}

std::string made_dds(const MadeSizes& sizes) {
    const bool cube = sizes.tile_layers == 6;
    std::string file = "DDS " + little(124, 4) + little(0x801007, 4) + little(sizes.height, 4) +
                       little(sizes.width, 4) + zeros(4) + little(sizes.layers, 4) + little(1, 4) +
                       zeros(44);
    file += little(32, 4) + little(0x41, 4) + zeros(4) + little(32, 4) + little(0xFF, 4) +
            little(0xFF00, 4) + little(0xFF0000, 4) + little(0xFF000000, 4);
    file += little(0x1008, 4) + little(cube ? 0xFE00 : (sizes.layers > 1 ? 0x200000 : 0), 4) +
            zeros(12);
    return file + std::string(std::size_t{8} * 4 * 4 * (cube ? 12 : 8), 'x');
}

std::string exr_attribute(const std::string& name, const std::string& type, std::uint32_t size,
                          const std::string& value) {
    return name + zeros(1) + type + zeros(1) + little(size, 4) + value;
}

std::string made_exr(const MadeSizes& sizes, const std::string& more_attributes) {
    const auto whole = [](const std::string& name, const std::string& type,
                          const std::string& value) {
        return exr_attribute(name, type, static_cast<std::uint32_t>(value.size()), value);
    };
    std::string channels;
    for (std::uint32_t i = 0; i < sizes.channels; ++i)
        channels += std::string(1, static_cast<char>('A' + i)) + zeros(1) + little(1, 4) +
                    zeros(4) + little(1, 4) + little(1, 4);
    const std::string window = zeros(8) + little(sizes.width - 1, 4) + little(sizes.height - 1, 4);
    std::string file =
        little(20000630, 4) + little(sizes.tile_width > 0 ? 0x202 : 2, 4) +
        whole("channels", "chlist", channels + zeros(1)) +
        whole("compression", "compression", zeros(1)) + whole("dataWindow", "box2i", window) +
        whole("displayWindow", "box2i", window) + whole("lineOrder", "lineOrder", zeros(1)) +
        whole("pixelAspectRatio", "float", little(0x3F800000, 4)) +
        whole("screenWindowCenter", "v2f", zeros(8)) +
        whole("screenWindowWidth", "float", little(0x3F800000, 4));
    if (sizes.tile_width > 0) {
        file += whole("tiles", "tiledesc",
                      little(sizes.tile_width, 4) + little(sizes.tile_height, 4) + zeros(1));
    }
    return file + more_attributes + zeros(1) + zeros(200);
}

std::string made_gif(const MadeSizes& sizes) {
    return "GIF89a" + little(sizes.width, 2) + little(sizes.height, 2) + "\x80" + zeros(2) +
           zeros(6) + "," + zeros(4) + little(4, 2) + little(4, 2) + zeros(1) + "\x02\x02\x84\x51" +
           zeros(1) + ";";
}

std::string made_hdr(const MadeSizes& sizes) {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(sizes.height) + " +X " +
           std::to_string(sizes.width) + "\n" + zeros(20);
}

std::string made_jpeg(const MadeSizes& sizes) {
    std::string table = "\xFF\xDB" + big(67, 2) + zeros(1) + std::string(64, '\x01');
    return "\xFF\xD8" + table + "\xFF\xC2" + big(17, 2) + "\x08" + big(sizes.height, 2) +
           big(sizes.width, 2) + "\x03\x01\x11" + zeros(1) + "\x02\x11" + zeros(1) + "\x03\x11" +
           zeros(1) + "\xFF\xDA" + big(12, 2) + "\x03\x01" + zeros(1) + "\x02" + zeros(1) + "\x03" +
           zeros(4) + zeros(20) + "\xFF\xD9";
}

std::string made_jpeg_2000(const MadeSizes& sizes, bool in_boxes) {
    std::string size = zeros(2) + big(sizes.width, 4) + big(sizes.height, 4) + zeros(8) +
                       big(sizes.tile_width, 4) + big(sizes.tile_height, 4) + zeros(8) +
                       big(sizes.channels, 2);
    for (std::uint32_t i = 0; i < sizes.channels; ++i)
        size += "\x07\x01\x01";
    const std::string coding = zeros(2) + big(1, 2) + zeros(1) + "\x05\x04\x04" + zeros(1) + "\x01";
    const std::string quantization = "\x40" + std::string(16, '\x48');
    const std::string stream = "\xFF\x4F\xFF\x51" + big(size.size() + 2, 2) + size + "\xFF\x52" +
                               big(coding.size() + 2, 2) + coding + "\xFF\x5C" +
                               big(quantization.size() + 2, 2) + quantization + "\xFF\x90" +
                               big(10, 2) + zeros(6) + zeros(1) + "\x01\xFF\x93" + zeros(20) +
                               "\xFF\xD9";
    if (!in_boxes) return stream;
    const std::string header =
        big(sizes.height, 4) + big(sizes.width, 4) + big(sizes.channels, 2) + "\x07\x07" + zeros(2);
    const auto box = [](const std::string& type, const std::string& content) {
        return big(content.size() + 8, 4) + type + content;
    };
    return box("jP  ", "\r\n\x87\n") + box("ftyp", "jp2 " + zeros(4) + "jp2 ") +
           box("jp2h", box("ihdr", header) + box("colr", "\x01" + zeros(2) + big(16, 4))) +
           box("jp2c", stream);
}

std::string made_pnm(const MadeSizes& sizes) {
    return "P6\n" + std::to_string(sizes.width) + " " + std::to_string(sizes.height) + "\n255\n" +
           std::string(8 * 4 * 3, 'x');
}

std::string made_sgi(const MadeSizes& sizes) {
    return big(474, 2) + "\x01\x01" + big(3, 2) + big(sizes.width, 2) + big(sizes.height, 2) +
           big(sizes.channels, 2) + zeros(500) + zeros(100);
}

std::string made_tga(const MadeSizes& sizes) {
    return zeros(2) + "\x0A" + zeros(9) + little(sizes.width, 2) + little(sizes.height, 2) +
           little(std::uint64_t{8} * sizes.channels, 1) + zeros(1) + zeros(64);
}

std::string made_tiff(const MadeSizes& sizes) {
    struct Tag {
        std::uint32_t number, type, count, value;
    };
    constexpr std::uint32_t kShort = 3, kLong = 4, kData = 8, kBytes = 8 * 8 * 3 * 4;
    std::vector<Tag> tags{{256, kLong, 1, sizes.width},
                          {257, kLong, 1, sizes.height},
                          {258, kShort, 1, 8},
                          {259, kShort, 1, 1},
                          {262, kShort, 1, 2}};
    const bool tiled = sizes.tile_width > 0;
    if (!tiled) tags.push_back({273, kLong, 1, kData});
    tags.push_back({277, kShort, 1, sizes.channels});
    if (!tiled) {
        tags.push_back({278, kLong, 1, sizes.height});
        tags.push_back({279, kLong, 1, kBytes});
    } else {
        tags.push_back({322, kLong, 1, sizes.tile_width});
        tags.push_back({323, kLong, 1, sizes.tile_height});
        tags.push_back({324, kLong, 1, kData});
        tags.push_back({325, kLong, 1, kBytes});
    }
    if (sizes.layers > 1) tags.push_back({32997, kLong, 1, sizes.layers});
    if (sizes.tile_layers > 0) tags.push_back({32998, kLong, 1, sizes.tile_layers});
    std::string file = "II*" + zeros(1) + little(kData + kBytes, 4) + std::string(kBytes, 'x') +
                       little(tags.size(), 2);
    for (const Tag& tag : tags)
        file += little(tag.number, 2) + little(tag.type, 2) + little(tag.count, 4) +
                little(tag.value, 4);
    return file + zeros(4);
}

std::string made_webp(const MadeSizes& sizes) {
    const std::uint32_t sides = (sizes.width - 1) | (sizes.height - 1) << 14 | 1u << 28;
    return "RIFF" + little(40, 4) + "WEBPVP8L" + little(20, 4) + "\x2F" + little(sides, 4) +
           zeros(20);
}

std::vector<MadeImage> small_images() {
    using OIIO::TypeDesc;
    MadeSizes cube, tiles, volume;
    cube.width = cube.height = 4;
    cube.tile_layers = 6;
    volume.layers = 8;
    tiles.tile_width = tiles.tile_height = 16;
    tiles.tile_layers = 4;
    return {written("rows.exr", "compression", "zip", 0, TypeDesc::HALF),
            written("piz.exr", "compression", "piz", 0, TypeDesc::FLOAT, 4),
            written("tiles.exr", "compression", "none", 16, TypeDesc::FLOAT),
            written("a.hdr", nullptr, "", 0, TypeDesc::FLOAT),
            written("rgb.png"),
            written("wide.png", nullptr, "", 0, TypeDesc::UINT16, 4),
            written("a.jpg"),
            written("rows.tif", "compression", "none"),
            written("zip.tif", "compression", "zip", 16, TypeDesc::UINT16),
            written("lzw.tif", "compression", "lzw", 0, TypeDesc::UINT8, 4),
            written("jpeg.tif", "compression", "jpeg"),
            written("planes.tif", "planarconfig", "separate", 16, TypeDesc::FLOAT),
            written("a.bmp"),
            written("a.gif"),
            written("a.jp2", OIIO::ImageSpec(64, 64, 3, TypeDesc::UINT8)),  // no smaller ones
            written("a.ppm"),
            {"a.pfm", "PF\n8 4\n-1\n" + zeros(std::size_t{8} * 4 * 3 * 4)},
            written("a.sgi"),
            written("a.webp"),
            written("raw.tga"),
            written("rle.tga", "compression", "rle", 0, TypeDesc::UINT8, 4),
            {"run_lengths.bmp", made_bmp({})},
            {"flat.dds", made_dds({})},
            {"cube.dds", made_dds(cube)},
            {"volume.dds", made_dds(volume)},
            {"deep_tiles.tif", made_tiff(tiles)}};
}

}  // namespace lxs::test
