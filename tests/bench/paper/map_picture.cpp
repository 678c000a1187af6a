// Pixel maps from images on disk, and as pictures.
#include "map_picture.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lxs/host/failure.h"
#include "study_file.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
namespace algo = OIIO::ImageBufAlgo;

PixelMap map_of(const Image& one_channel) {
    PixelMap map{one_channel.spec().width, one_channel.spec().height, {}};
    map.values.resize(one_channel.spec().image_pixels());
    one_channel.get_pixels(one_channel.roi(), OIIO::TypeDesc::DOUBLE, map.values.data());
    return map;
}

}  // namespace

std::optional<PixelMap> read_map(const fs::path& file, const std::string& layer) {
    Image whole(file.string());
    if (!whole.read(0, 0, true, OIIO::TypeDesc::FLOAT)) {
        throw StudyError(fmt::format("cannot read '{}': {}", file.string(), whole.geterror()));
    }
    const int channel = whole.spec().channelindex(layer + ".Y");
    if (channel < 0) return std::nullopt;
    return map_of(algo::channels(whole, 1, std::array{channel}));
}

PixelMap luminance_map(const Image& image) {
    return map_of(algo::channel_sum(image, std::array{0.2126f, 0.7152f, 0.0722f}));
}

double quantile(const PixelMap& map, double share) {
    std::vector<double> values = map.values;
    const auto last = double(values.size() - 1);
    const auto middle = values.begin() + std::ptrdiff_t(std::clamp(share, 0.0, 1.0) * last);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

void write_picture(const fs::path& file, const PixelMap& map, double white) {
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
