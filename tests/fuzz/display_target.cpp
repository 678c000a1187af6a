// Fuzz target: what --display-server is given and sends. The address is parsed, and says the same
// when it is parsed again; the packets of an image, whatever its name, are read as tev reads them.
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "fuzz_target.h"
#include "input_bytes.h"
#include "lxs/host/display_server.h"
#include "tev_packet.h"
#include "tev_reader.h"

namespace {

void check_address(const std::string& text) {
    try {
        const lxs::ViewerAddress address = lxs::ViewerAddress::parse(text);
        if (lxs::ViewerAddress::parse(address.text()).text() != address.text()) std::abort();
    } catch (const std::invalid_argument& refusal) {
        if (std::string(refusal.what()).empty()) throw;
    }
}

/// What follows the length, which must be that of the packet.
std::vector<char> after_length(const std::string& packet) {
    std::uint32_t length = 0;
    if (packet.size() < sizeof length) std::abort();
    packet.copy(reinterpret_cast<char*>(&length), sizeof length);
    if (length != packet.size()) std::abort();
    return {packet.begin() + sizeof length, packet.end()};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::InputBytes bytes(data, size);
    check_address(bytes.text(63));
    const std::string name = bytes.text(255);
    const auto width = static_cast<std::uint32_t>(1 + bytes.below(8));
    const auto height = static_cast<std::uint32_t>(1 + bytes.below(8));
    std::vector<lxs::Rgb> pixels(std::size_t{width} * height, lxs::Rgb(0.0f));
    for (lxs::Rgb& pixel : pixels)
        pixel = lxs::Rgb(static_cast<float>(bytes.byte()));
    std::map<std::string, lxs::test::ShownImage> images;
    // A packet that the viewer does not understand throws, and that is found.
    lxs::test::take_tev_packet(after_length(lxs::tev::create_image(name, width, height)), images);
    lxs::test::take_tev_packet(after_length(lxs::tev::update_image(name, width, height, pixels)),
                               images);
    const std::string shown = name.substr(0, name.find('\0'));
    if (images.size() != 1 || !images.contains(shown)) std::abort();
    const lxs::test::ShownImage& image = images.at(shown);
    for (const std::vector<float>& channel : image.values) {
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (channel.at(i) != pixels[i][0]) std::abort();
        }
    }
    if (image.updates != 1 || image.values.size() != 3) std::abort();
    return 0;
}
