// Images of a study on disk: what an EXR holds, by layer.
#include "image_file.h"

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <array>
#include <memory>
#include <system_error>

#include "lxs/host/failure.h"
#include "study_file.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
constexpr std::array kChannels{"R", "G", "B"};
constexpr const char* kMapChannel = "Y";

std::string channel_name(const std::string& layer, const char* channel) {
    return layer.empty() ? channel : layer + '.' + channel;
}

std::vector<std::string> channel_names(const NamedLayer& layer) {
    if (layer.image.nchannels() == 1) return {channel_name(layer.name, kMapChannel)};
    std::vector<std::string> names;
    names.reserve(kChannels.size());
    for (const char* channel : kChannels)
        names.push_back(channel_name(layer.name, channel));
    return names;
}

std::unique_ptr<OIIO::ImageInput> open_image(const fs::path& file) {
    // Not by ImageBuf: its cache knows a file by name and second, and takes the layout of the file
    // that was there before for the new one's.
    auto input = OIIO::ImageInput::open(file.string());
    if (!input)
        throw StudyError(fmt::format("cannot read '{}': {}", file.string(), OIIO::geterror()));
    return input;
}

}  // namespace

std::optional<Image> read_layer(const fs::path& file, const std::string& layer) {
    const auto input = open_image(file);
    const OIIO::ImageSpec& spec = input->spec();
    std::array<int, kChannels.size()> order{};
    for (std::size_t i = 0; i < kChannels.size(); ++i) {
        order[i] = spec.channelindex(channel_name(layer, kChannels[i]));
        if (order[i] < 0) return std::nullopt;
    }
    Image whole(OIIO::ImageSpec(spec.width, spec.height, spec.nchannels, OIIO::TypeDesc::FLOAT));
    if (!input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, whole.localpixels())) {
        throw StudyError(fmt::format("cannot read '{}': {}", file.string(), input->geterror()));
    }
    const std::array<std::string, kChannels.size()> names{"R", "G", "B"};
    return OIIO::ImageBufAlgo::channels(whole, int(order.size()), order, {}, names);
}

std::optional<PixelMap> read_map(const fs::path& file, const std::string& layer) {
    const auto input = open_image(file);
    const OIIO::ImageSpec& spec = input->spec();
    const int channel = spec.channelindex(channel_name(layer, kMapChannel));
    if (channel < 0) return std::nullopt;
    PixelMap map{spec.width, spec.height, {}};
    map.values.resize(spec.image_pixels());
    if (!input->read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::DOUBLE, map.values.data()))
        throw StudyError(fmt::format("cannot read '{}': {}", file.string(), input->geterror()));
    return map;
}

Image read_image(const fs::path& file) {
    auto image = read_layer(file, "");
    if (!image) {
        throw StudyError(fmt::format("'{}' has no channels R, G and B", file.string()));
    }
    return *std::move(image);
}

void write_layers(const fs::path& file, const std::vector<NamedLayer>& layers) {
    Image all;
    for (const NamedLayer& layer : layers) {
        const std::vector<std::string> names = channel_names(layer);
        const Image named =
            OIIO::ImageBufAlgo::channels(layer.image, int(names.size()), {}, {}, names);
        all = all.initialized() ? OIIO::ImageBufAlgo::channel_append(all, named) : named;
    }
    make_folder(file.parent_path());
    const fs::path beside = file.string() + ".tmp";
    const bool written = all.write(beside.string(), OIIO::TypeDesc::FLOAT, "openexr");
    std::error_code error;
    if (written) fs::rename(beside, file, error);
    if (!written || error) {
        throw lxs::OutputFailure(fmt::format("cannot write '{}': {}", file.string(),
                                             written ? error.message() : all.geterror()));
    }
}

}  // namespace bench
