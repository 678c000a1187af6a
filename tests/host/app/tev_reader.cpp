// Reads packets of tev's protocol. Written after tev's reader (Ipc.cpp), apart from what sends.
#include "tev_reader.h"

#include <cstring>
#include <stdexcept>

namespace lxs::test {
namespace {

class Reader {
  public:
    explicit Reader(const std::vector<char>& bytes) : bytes_(bytes) {}
    template <class T>
    T number() {
        T value;
        if (bytes_.size() - at_ < sizeof value) throw std::runtime_error("the packet ends");
        std::memcpy(&value, bytes_.data() + at_, sizeof value);
        at_ += sizeof value;
        return value;
    }
    std::string text() {
        std::string text;
        while (const char c = number<char>())
            text += c;
        return text;
    }
    std::size_t left() const { return bytes_.size() - at_; }

  private:
    const std::vector<char>& bytes_;
    std::size_t at_ = 0;
};

template <class T>
std::vector<T> numbers(Reader& reader, std::size_t count) {
    std::vector<T> values(count);
    for (T& value : values)
        value = reader.number<T>();
    return values;
}

std::vector<std::string> texts(Reader& reader, std::size_t count) {
    std::vector<std::string> values(count);
    for (std::string& value : values)
        value = reader.text();
    return values;
}

}  // namespace

void take_tev_packet(const std::vector<char>& packet, std::map<std::string, ShownImage>& images) {
    Reader reader(packet);
    const auto type = reader.number<std::uint8_t>();
    (void)reader.number<std::uint8_t>();  // whether it comes to the front
    const std::string name = reader.text();
    ShownImage& image = images[name];
    if (type == 4) {  // CreateImage
        image.width = reader.number<std::int32_t>();
        image.height = reader.number<std::int32_t>();
        image.channels = texts(reader, std::size_t(reader.number<std::int32_t>()));
        ++image.created;
    } else if (type == 6) {  // UpdateImageV3
        const auto channels = std::size_t(reader.number<std::int32_t>());
        if (texts(reader, channels) != image.channels) throw std::runtime_error("other channels");
        const auto window = numbers<std::int32_t>(reader, 4);
        if (window != std::vector<std::int32_t>{0, 0, image.width, image.height})
            throw std::runtime_error("not the whole image");
        const auto offsets = numbers<std::int64_t>(reader, channels);
        const auto strides = numbers<std::int64_t>(reader, channels);
        const auto data = numbers<float>(reader, reader.left() / sizeof(float));
        image.values.assign(channels, {});
        for (std::size_t c = 0; c < channels; ++c)
            for (int i = 0; i < image.width * image.height; ++i)
                image.values[c].push_back(data.at(std::size_t(offsets[c] + i * strides[c])));
        ++image.updates;
    } else {
        throw std::runtime_error("a packet of another type");
    }
    if (reader.left() != 0 && type == 4) throw std::runtime_error("more than the packet holds");
}

}  // namespace lxs::test
