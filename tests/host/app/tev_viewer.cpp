// A stand-in for the viewer tev.
#include "tev_viewer.h"

#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <stdexcept>
#include <thread>

namespace lxs::test {
using boost::asio::ip::tcp;

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
        take_tev_packet(packet, images);
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
