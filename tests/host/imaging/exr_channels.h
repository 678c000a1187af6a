// The channels of the EXR that a film writes, read back.
#pragma once

#include <OpenImageIO/imageio.h>

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "lxs/imaging/imaging.h"
#include "temporary_folder.h"

namespace lxs::test {

/// By name, row by row.
inline std::map<std::string, std::vector<float>> channels_of(const FileFilm& film) {
    const files::TemporaryFolder folder;
    const std::string path = folder / "image.exr";
    film.write_exr(path, {});
    const auto input = OIIO::ImageInput::open(path);
    if (!input) throw std::runtime_error(OIIO::geterror());
    std::map<std::string, std::vector<float>> channels;
    for (int c = 0; c < input->spec().nchannels; ++c) {
        std::vector<float>& values = channels[input->spec().channelnames[std::size_t(c)]];
        values.resize(std::size_t{film.width()} * film.height());
        if (!input->read_image(0, 0, c, c + 1, OIIO::TypeDesc::FLOAT, values.data()))
            throw std::runtime_error(input->geterror());
    }
    return channels;
}

}  // namespace lxs::test
