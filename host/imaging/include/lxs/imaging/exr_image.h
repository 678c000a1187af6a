// An OpenEXR file as plain data: what was rendered elsewhere, read back.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "lxs/imaging/film_frame.h"

namespace lxs {

/// Key and value texts that go into the header of an EXR file.
using ImageMetadata = std::map<std::string, std::string>;

struct ExrImage {
    FilmFrame frame;
    /// By name ("R", "error.G"): frame.width * frame.height values, row by row.
    std::map<std::string, std::vector<float>> channels;
    ImageMetadata metadata;  ///< the header's texts
};

/// Reads scan-line or tiled files of a single part; channels of other types than 32-bit float are
/// converted. Throws std::runtime_error with the path and the cause: no file, no EXR file, damaged,
/// sampled channels, or more than kMaxFilmPixels.
ExrImage read_exr(const std::string& path);
/// The same of a file's bytes; `name` stands for it in messages.
ExrImage decode_exr(std::span<const std::byte> bytes, const std::string& name);

/// The bytes of such a file (32-bit float, ZIP). Throws std::exception when OpenEXR refuses a name.
std::vector<std::byte> encode_exr(const ExrImage& image);

}  // namespace lxs
