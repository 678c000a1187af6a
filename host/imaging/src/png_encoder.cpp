// PNG files in memory.
#include "png_encoder.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <stdexcept>

namespace lxs {

std::vector<std::byte> encode_png(std::uint32_t width, std::uint32_t height, double gamma,
                                  std::span<const std::uint8_t> rgb) {
    OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height), 3,
                         OIIO::TypeDesc::UINT8);
    const bool srgb = std::abs(gamma - 2.2) < 0.01;
    spec.attribute("oiio:ColorSpace", srgb ? "sRGB" : "GammaCorrected");
    if (!srgb) spec.attribute("oiio:Gamma", static_cast<float>(gamma));

    std::vector<unsigned char> encoded;
    OIIO::Filesystem::IOVecOutput memory(encoded);
    const auto output = OIIO::ImageOutput::create("png", &memory);
    if (!output) throw std::runtime_error(OIIO::geterror());
    if (!output->open("memory.png", spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, rgb.data()) || !output->close()) {
        throw std::runtime_error(output->geterror());
    }
    const auto bytes = std::as_bytes(std::span(encoded));
    return {bytes.begin(), bytes.end()};
}

}  // namespace lxs
