// Packets of the viewer tev's protocol: a length of 4 bytes, which counts itself, a type of one
// byte, then what the type asks for; numbers with the lowest byte first, texts with a zero at the
// end. The largest film, 2^27 pixels, takes less than the 4 GB that the length can say.
#include "tev_packet.h"

#include <bit>
#include <cstring>
#include <utility>

namespace lxs::tev {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are sent as they are in memory");
static_assert(sizeof(Rgb) == 3 * sizeof(float));

enum class Type : std::uint8_t { CreateImage = 4, UpdateImageV3 = 6 };

class Packet {
  public:
    Packet(Type type, std::size_t room) {
        bytes_.reserve(room);
        add(std::uint32_t{0});
        add(type);
    }
    template <class Number>
    void add(Number value) {
        add_bytes(&value, sizeof value);
    }
    void add(std::string_view text) {
        add_bytes(text.data(), text.find('\0') < text.size() ? text.find('\0') : text.size());
        bytes_.push_back('\0');
    }
    void add_bytes(const void* data, std::size_t size) {
        bytes_.append(static_cast<const char*>(data), size);
    }
    std::string finish() && {
        const auto size = static_cast<std::uint32_t>(bytes_.size());
        std::memcpy(bytes_.data(), &size, sizeof size);
        return std::move(bytes_);
    }

  private:
    std::string bytes_;
};

void add_channels(Packet& packet) {
    packet.add(std::int32_t{3});
    for (const char* channel : {"R", "G", "B"})
        packet.add(std::string_view(channel));
}

}  // namespace

std::string create_image(std::string_view name, std::uint32_t width, std::uint32_t height) {
    Packet packet(Type::CreateImage, name.size() + 64);
    packet.add(std::uint8_t{1});  // comes to the front
    packet.add(name);
    packet.add(static_cast<std::int32_t>(width));
    packet.add(static_cast<std::int32_t>(height));
    add_channels(packet);
    return std::move(packet).finish();
}

std::string update_image(std::string_view name, std::uint32_t width, std::uint32_t height,
                         std::span<const Rgb> pixels) {
    Packet packet(Type::UpdateImageV3, name.size() + 128 + pixels.size_bytes());
    packet.add(std::uint8_t{0});
    packet.add(name);
    add_channels(packet);
    for (const std::uint32_t number : {0u, 0u, width, height})
        packet.add(static_cast<std::int32_t>(number));
    for (const std::int64_t offset : {0, 1, 2})
        packet.add(offset);
    for (const std::int64_t stride : {3, 3, 3})
        packet.add(stride);
    packet.add_bytes(pixels.data(), pixels.size_bytes());
    return std::move(packet).finish();
}

}  // namespace lxs::tev
