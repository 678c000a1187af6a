// Pixel maps from images, and as pictures.
#include "map_picture.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lxs/host/failure.h"
#include "study_file.h"

namespace bench {

PixelMap luminance_map(const Image& image) {
    const Image luminance =
        OIIO::ImageBufAlgo::channel_sum(image, std::array{0.2126f, 0.7152f, 0.0722f});
    PixelMap map{luminance.spec().width, luminance.spec().height, {}};
    map.values.resize(luminance.spec().image_pixels());
    luminance.get_pixels(luminance.roi(), OIIO::TypeDesc::DOUBLE, map.values.data());
    return map;
}

void write_picture(const std::filesystem::path& file, const PixelMap& map, double white) {
    constexpr double kGamma = 2.2;
    std::vector<float> grey(map.values.size());
    for (std::size_t i = 0; i < grey.size(); ++i) {
        const double value = white > 0 ? std::clamp(map.values[i] / white, 0.0, 1.0) : 0.0;
        grey[i] = float(std::pow(value, 1 / kGamma));
    }
    Image picture(OIIO::ImageSpec(map.width_px, map.height_px, 1, OIIO::TypeDesc::FLOAT));
    picture.set_pixels(picture.roi(), OIIO::TypeDesc::FLOAT, grey.data());
    make_folder(file.parent_path());
    if (!picture.write(file.string(), OIIO::TypeDesc::UINT8, "png")) {
        throw lxs::OutputFailure(
            fmt::format("cannot write '{}': {}", file.string(), picture.geterror()));
    }
}

}  // namespace bench
