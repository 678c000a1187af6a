// Reads OpenEXR files, of this renderer or of others.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVersion.h>
#include <OpenEXR/ImfXdr.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <stdexcept>
#include <system_error>

#include "lxs/images/exr_header.h"
#include "lxs/imaging/exr_image.h"

namespace lxs {
namespace {

class BytesStream : public Imf::IStream {
  public:
    explicit BytesStream(std::span<const std::byte> bytes)
        : Imf::IStream("memory"), bytes_(bytes) {}

    bool read(char data[], int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (size > bytes_.size() - position_) throw std::runtime_error("the file ends too early");
        std::memcpy(data, bytes_.data() + position_, size);
        position_ += size;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override {
        if (position > bytes_.size()) throw std::runtime_error("the file ends too early");
        position_ = position;
    }

  private:
    std::span<const std::byte> bytes_;
    std::size_t position_ = 0;
};

FilmFrame frame_of(const Imath::Box2i& display, const Imath::Box2i& data) {
    const auto size = [](int min, int max) { return std::int64_t{max} - min + 1; };
    const std::int64_t width = size(data.min.x, data.max.x), height = size(data.min.y, data.max.y);
    const std::int64_t x_resolution = size(display.min.x, display.max.x);
    const std::int64_t y_resolution = size(display.min.y, display.max.y);
    const std::int64_t x = std::int64_t{data.min.x} - display.min.x;
    const std::int64_t y = std::int64_t{data.min.y} - display.min.y;
    if (width < 1 || height < 1 || x < 0 || y < 0 || x + width > x_resolution ||
        y + height > y_resolution) {
        throw std::runtime_error("its pixels lie outside of its image");
    }
    const auto most = static_cast<std::int64_t>(kMaxFilmPixels);
    if (x_resolution > most || y_resolution > most || width > most / height)
        throw std::runtime_error(fmt::format("more than {} pixels", most));
    const auto narrow = [](std::int64_t value) { return static_cast<std::uint32_t>(value); };
    return {narrow(x_resolution), narrow(y_resolution), narrow(x), narrow(y),
            narrow(width),        narrow(height)};
}

ImageMetadata texts_of(const Imf::Header& header) {
    ImageMetadata texts;
    for (auto entry = header.begin(); entry != header.end(); ++entry) {
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&entry.attribute());
        if (text) texts[entry.name()] = text->value();
    }
    return texts;
}

std::vector<std::string> channels_of(const Imf::Header& header) {
    std::vector<std::string> names;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        names.emplace_back(channel.name());
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
            throw std::runtime_error(fmt::format("channel '{}' is subsampled", names.back()));
    }
    return names;
}

/// A few bytes must not claim gigabytes, of pixels or of the table of offsets.
void check_size(const FilmFrame& frame, std::size_t channels, std::size_t file_bytes) {
    constexpr double kMostCompressed = 2000;  // ZIP's best is a thousandth
    constexpr double kMostLines = 256;        // of a chunk, which takes 16 bytes at least
    const double pixels = 2.0 * frame.width * frame.height * static_cast<double>(channels);
    const auto bytes = static_cast<double>(file_bytes);
    if (pixels > kMostCompressed * bytes || frame.height * 16 / kMostLines > bytes)
        throw std::runtime_error("the file is too short for its pixels");
}

/// What the header claims, before OpenEXR believes it.
void check_header(std::span<const std::byte> bytes) {
    BytesStream stream(bytes);
    (void)exr_claims(stream, bytes.size());
    stream.seekg(4);  // the magic number
    int version = 0;
    Imf::Xdr::read<Imf::StreamIO>(stream, version);
    if (Imf::isMultiPart(version)) throw std::runtime_error("it has several parts");
    Imf::Header header;
    header.readFrom(stream, version);
    check_size(frame_of(header.displayWindow(), header.dataWindow()), channels_of(header).size(),
               bytes.size());
}

ExrImage decode(std::span<const std::byte> bytes) {
    check_header(bytes);
    BytesStream stream(bytes);
    Imf::InputFile file(stream, 1);
    const Imf::Header& header = file.header();
    const Imath::Box2i window = header.dataWindow();
    ExrImage image;
    image.frame = frame_of(header.displayWindow(), window);
    image.metadata = texts_of(header);
    Imf::FrameBuffer buffer;
    const std::size_t pixels = std::size_t{image.frame.width} * image.frame.height;
    for (const std::string& name : channels_of(header)) {
        std::vector<float>& values = image.channels[name];
        values.resize(pixels);
        buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), window));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return image;
}

}  // namespace

ExrImage decode_exr(std::span<const std::byte> bytes, const std::string& name) {
    try {
        return decode(bytes);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("cannot read '{}': {}", name, error.what()));
    }
}

ExrImage read_exr(const std::string& path) {
    std::vector<std::byte> bytes;
    try {
        std::ifstream file;
        file.exceptions(std::ios::failbit | std::ios::badbit);
        errno = 0;
        file.open(path, std::ios::binary);
        bytes.resize(std::filesystem::file_size(path));
        file.read(reinterpret_cast<char*>(bytes.data()),
                  static_cast<std::streamsize>(bytes.size()));
    } catch (const std::filesystem::filesystem_error& error) {
        throw std::runtime_error(fmt::format("cannot read '{}': {}", path, error.code().message()));
    } catch (const std::ios::failure&) {
        const int cause = errno != 0 ? errno : EIO;
        throw std::runtime_error(
            fmt::format("cannot read '{}': {}", path, std::generic_category().message(cause)));
    }
    return decode_exr(bytes, path);
}

}  // namespace lxs
