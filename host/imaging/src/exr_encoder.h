// OpenEXR files in memory.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "film_settings.h"
#include "lxs/imaging/imaging.h"

namespace lxs {

/// A layer of three channels; "" names the image itself (R, G, B), others "name.R" and so on.
struct ColorLayer {
    std::string name;
    std::vector<Rgb> values;
    std::array<char, 3> channels{'R', 'G', 'B'};
};

/// A layer of one channel, "name.Y"; without a name "Y".
struct FloatLayer {
    std::string name;
    std::span<const float> values;
    char channel = 'Y';
};

/// What a file holds beside its frame.
struct FileLayers {
    std::vector<ColorLayer> colors;
    std::vector<FloatLayer> floats;
    std::deque<std::vector<float>> values;  ///< of some of `floats`
    ImageMetadata metadata;
};

/// The bytes of a scan-line EXR (32-bit float, ZIP) with the frame's window as data window. All
/// layers have width * height values. Throws std::exception when OpenEXR refuses a name.
std::vector<std::byte> encode_exr(const FilmFrame& frame, const FileLayers& layers);

}  // namespace lxs
