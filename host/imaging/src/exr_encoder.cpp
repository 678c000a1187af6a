// OpenEXR files in memory.
#include "exr_encoder.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cstring>

namespace lxs {
namespace {

/// Collects what OpenEXR writes; it goes back to fill in the table of offsets.
class MemoryStream : public Imf::OStream {
  public:
    MemoryStream() : Imf::OStream("memory") {}

    void write(const char data[], int count) override {
        const auto size = static_cast<std::size_t>(count);
        bytes_.resize(std::max(bytes_.size(), position_ + size));
        std::memcpy(bytes_.data() + position_, data, size);
        position_ += size;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    std::vector<std::byte> take() { return std::move(bytes_); }

  private:
    std::vector<std::byte> bytes_;
    std::size_t position_ = 0;
};

/// Header and frame buffer, filled channel by channel.
class Channels {
  public:
    Channels(const FilmFrame& frame, const ImageMetadata& metadata)
        : window_(Imath::V2i(static_cast<int>(frame.x), static_cast<int>(frame.y)),
                  Imath::V2i(static_cast<int>(frame.x + frame.width - 1),
                             static_cast<int>(frame.y + frame.height - 1))),
          header_(Imath::Box2i(Imath::V2i(0), Imath::V2i(static_cast<int>(frame.x_resolution) - 1,
                                                         static_cast<int>(frame.y_resolution) - 1)),
                  window_) {
        header_.compression() = Imf::ZIP_COMPRESSION;
        for (const auto& [key, value] : metadata) {
            header_.insert(key, Imf::StringAttribute(value));
        }
    }

    void add(const std::string& name, const float* values, std::size_t floats_per_pixel) {
        header_.channels().insert(name, Imf::Channel(Imf::FLOAT));
        const std::size_t pixel_bytes = floats_per_pixel * sizeof(float);
        const int width = window_.max.x - window_.min.x + 1;
        buffer_.insert(name, Imf::Slice::Make(Imf::FLOAT, values, window_, pixel_bytes,
                                              pixel_bytes * static_cast<std::size_t>(width)));
    }

    std::vector<std::byte> encode() const {
        MemoryStream stream;
        {
            Imf::OutputFile file(stream, header_);
            file.setFrameBuffer(buffer_);
            file.writePixels(window_.max.y - window_.min.y + 1);
        }
        return stream.take();
    }

  private:
    Imath::Box2i window_;
    Imf::Header header_;
    Imf::FrameBuffer buffer_;
};

}  // namespace

std::vector<std::byte> encode_exr(const FileLayers& layers) {
    Channels channels(layers.frame, layers.metadata);
    for (const ColorLayer& layer : layers.colors) {
        const std::string prefix = layer.name.empty() ? "" : layer.name + ".";
        const float* first = &layer.values.front().x;
        for (std::size_t c = 0; c < 3; ++c)
            channels.add(prefix + layer.channels[c], first + c, 3);
    }
    for (const FloatLayer& layer : layers.floats) {
        const std::string prefix = layer.name.empty() ? "" : layer.name + ".";
        channels.add(prefix + layer.channel, layer.values.data(), 1);
    }
    return channels.encode();
}

std::vector<std::byte> encode_exr(const ExrImage& image) {
    Channels channels(image.frame, image.metadata);
    for (const auto& [name, values] : image.channels)
        channels.add(name, values.data(), 1);
    return channels.encode();
}

}  // namespace lxs
