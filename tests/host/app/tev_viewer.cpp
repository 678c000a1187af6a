// A stand-in for the viewer tev. Written after tev's reader (Ipc.cpp), apart from what sends.
#include "tev_viewer.h"

#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <cstring>
#include <stdexcept>
#include <thread>

namespace lxs::test {
namespace {

using boost::asio::ip::tcp;

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

void take(const std::vector<char>& packet, std::map<std::string, ShownImage>& images) {
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

}  // namespace

struct TevViewer::Inside {
    boost::asio::io_context context;
    tcp::acceptor acceptor{context, {boost::asio::ip::address_v4::loopback(), 0}};
    std::map<std::string, ShownImage> images;
    std::atomic<int> connections{0};
    std::string mistake;
    std::thread thread;

    /// False when the sender has hung up.
    bool take_packet(tcp::socket& socket) {
        boost::system::error_code error;
        std::uint32_t size = 0;
        boost::asio::read(socket, boost::asio::buffer(&size, sizeof size), error);
        if (error) return false;
        std::vector<char> packet(size - sizeof size);
        boost::asio::read(socket, boost::asio::buffer(packet));
        take(packet, images);
        return true;
    }

    void listen(int hang_up_after) try {
        for (bool again = true; again;) {
            tcp::socket socket = acceptor.accept();
            ++connections;
            int packets = 0;
            again = false;
            while (!again && take_packet(socket))
                again = connections == 1 && ++packets == hang_up_after;
        }
    } catch (const std::exception& error) {
        mistake = error.what();
    }
};

TevViewer::TevViewer(int hang_up_after) : inside_(std::make_unique<Inside>()) {
    inside_->thread = std::thread([this, hang_up_after] { inside_->listen(hang_up_after); });
}

TevViewer::~TevViewer() {
    if (!inside_->thread.joinable()) return;
    // Nobody came: a connection of our own ends the wait.
    boost::system::error_code ignored;
    tcp::socket socket(inside_->context);
    socket.connect(inside_->acceptor.local_endpoint(), ignored);
    socket.close(ignored);
    inside_->thread.join();
}

std::string TevViewer::address() const {
    return "127.0.0.1:" + std::to_string(inside_->acceptor.local_endpoint().port());
}

std::map<std::string, ShownImage> TevViewer::images() {
    inside_->thread.join();
    if (!inside_->mistake.empty()) throw std::runtime_error(inside_->mistake);
    return inside_->images;
}

int TevViewer::connections() const {
    return inside_->connections;
}

}  // namespace lxs::test
