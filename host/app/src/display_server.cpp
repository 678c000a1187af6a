// Shows the image so far in the viewer tev, over its protocol.
#include "lxs/host/display_server.h"

#include <fmt/format.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <charconv>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <utility>

#include "lxs/sdk/diagnostics.h"
#include "tev_packet.h"

namespace lxs {
namespace {

using boost::asio::ip::tcp;

/// A viewer that hangs must not hold up a render for longer.
constexpr std::chrono::seconds kPatience{2};

bool is_port(const std::string& text) {
    unsigned port = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, port);
    return error == std::errc() && rest == end && port >= 1 && port <= 65535;
}

}  // namespace

ViewerAddress ViewerAddress::parse(const std::string& text) {
    ViewerAddress address;
    const bool bracketed = text.starts_with('[');
    const std::size_t close = bracketed ? text.find(']') : 0;
    const std::size_t colon = text.find(':', close == std::string::npos ? 0 : close);
    address.host = bracketed ? text.substr(1, close - 1) : text.substr(0, colon);
    if (colon != std::string::npos) address.port = text.substr(colon + 1);
    const bool after_bracket = !bracketed || close + 1 == std::min(colon, text.size());
    if (address.host.empty() || close == std::string::npos || !after_bracket ||
        !is_port(address.port))
        throw std::invalid_argument("expected HOST or HOST:PORT, found " + in_quotes(text));
    return address;
}

std::string ViewerAddress::text() const {
    const bool numbers = host.find(':') != std::string::npos;
    return numbers ? fmt::format("[{}]:{}", host, port) : fmt::format("{}:{}", host, port);
}

class DisplayServer::Connection {
  public:
    explicit Connection(const ViewerAddress& address) {
        tcp::resolver resolver(context_);
        const auto places = resolver.resolve(address.host, address.port);
        boost::asio::async_connect(socket_, places,
                                   [this](const auto& error, const auto&) { done_ = error; });
        wait();
    }
    void send(const std::string& packet) {
        boost::asio::async_write(socket_, boost::asio::buffer(packet),
                                 [this](const auto& error, std::size_t) { done_ = error; });
        wait();
    }

  private:
    /// For what was begun last.
    void wait() {
        done_.reset();
        context_.restart();
        context_.run_for(kPatience);
        if (!done_) {
            socket_.close();
            context_.run();  // what was begun ends with an error
            throw std::runtime_error("it does not answer");
        }
        if (*done_) throw std::runtime_error(done_->message());
    }

    boost::asio::io_context context_;
    tcp::socket socket_{context_};
    std::optional<boost::system::error_code> done_;
};

DisplayServer::DisplayServer(ViewerAddress address, std::string name)
    : address_(std::move(address)), name_(std::move(name)) {}
DisplayServer::~DisplayServer() = default;
DisplayServer::DisplayServer(DisplayServer&&) noexcept = default;
DisplayServer& DisplayServer::operator=(DisplayServer&&) noexcept = default;

void DisplayServer::show(std::uint32_t width, std::uint32_t height, std::span<const Rgb> pixels) {
    try {
        if (!connection_) {
            connection_ = std::make_unique<Connection>(address_);
            connection_->send(tev::create_image(name_, width, height));
        }
        connection_->send(tev::update_image(name_, width, height, pixels));
    } catch (const std::runtime_error& error) {
        connection_.reset();
        throw std::runtime_error(
            fmt::format("cannot show the image at {}: {}", address_.text(), error.what()));
    }
}

}  // namespace lxs
