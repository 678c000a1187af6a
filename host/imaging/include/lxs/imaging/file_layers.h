// What the film's EXR holds, as plain data.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lxs/imaging/exr_image.h"
#include "lxs/imaging/film_frame.h"
#include "lxs/sdk/types.h"

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
    std::vector<float> values;
    char channel = 'Y';
};

/// All layers have width * height values of the frame's window, row by row; the image is the first
/// of `colors`.
struct FileLayers {
    FilmFrame frame;
    std::vector<ColorLayer> colors;
    std::vector<FloatLayer> floats;
    ImageMetadata metadata;
};

/// Writes linear 32-bit floats beside `path` and renames; throws std::runtime_error with the path
/// and the cause, leaving an older file whole.
void write_exr(const std::string& path, const FileLayers& layers);

}  // namespace lxs
