// Shows the image so far in the viewer tev, over its protocol.
#include "lxs/host/display_server.h"

#include <fmt/format.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <charconv>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "lxs/sdk/diagnostics.h"
#include "tev_packet.h"

namespace lxs {
namespace {

using boost::asio::ip::tcp;

/// A viewer that hangs must not hold up a render for longer, from the search for its name on.
constexpr std::chrono::seconds kPatience{2};

/// Those of a name or a number, as numbers. Takes as long as the system's search does.
std::vector<std::string> addresses_of(const std::string& host) {
    boost::asio::io_context context;
    std::vector<std::string> addresses;
    for (const auto& entry : tcp::resolver(context).resolve(host, ""))
        addresses.push_back(entry.endpoint().address().to_string());
    return addresses;
}

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

/// A search for the addresses of a host, which can't be called off: it is left to a thread of its
/// own, and outlives whoever does not wait for it.
class DisplayServer::Search {
  public:
    Search(const FindAddresses& find, const std::string& host) : found_(std::make_shared<Found>()) {
        std::thread([find, host, found = found_] {
            std::vector<std::string> addresses;
            std::string failure;
            try {
                addresses = find(host);
            } catch (const std::exception& error) {
                failure = error.what();
            }
            const std::lock_guard lock(found->mutex);
            found->addresses = std::move(addresses);
            found->failure = std::move(failure);
            found->done = true;
            found->news.notify_all();
        }).detach();
    }
    /// Nothing if they are not known by then; throws std::runtime_error if there are none.
    std::optional<std::vector<std::string>> result(Clock::time_point deadline) const {
        std::unique_lock lock(found_->mutex);
        if (!found_->news.wait_until(lock, deadline, [&] { return found_->done; }))
            return std::nullopt;
        if (!found_->failure.empty()) throw std::runtime_error(found_->failure);
        return found_->addresses;
    }

  private:
    struct Found {
        std::mutex mutex;
        std::condition_variable news;
        bool done = false;
        std::vector<std::string> addresses;
        std::string failure;
    };
    std::shared_ptr<Found> found_;
};

class DisplayServer::Connection {
  public:
    Connection(const std::vector<std::string>& addresses, const std::string& port,
               Clock::time_point deadline) {
        std::vector<tcp::endpoint> places;
        for (const std::string& address : addresses)
            places.emplace_back(boost::asio::ip::make_address(address),
                                static_cast<unsigned short>(std::stoi(port)));
        boost::asio::async_connect(socket_, places,
                                   [this](const auto& error, const auto&) { done_ = error; });
        wait(deadline);
    }
    void send(const std::string& packet, Clock::time_point deadline) {
        boost::asio::async_write(socket_, boost::asio::buffer(packet),
                                 [this](const auto& error, std::size_t) { done_ = error; });
        wait(deadline);
    }

  private:
    /// For what was begun last.
    void wait(Clock::time_point deadline) {
        done_.reset();
        context_.restart();
        context_.run_until(deadline);
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

DisplayServer::DisplayServer(ViewerAddress address, std::string name, FindAddresses find)
    : address_(std::move(address)),
      name_(std::move(name)),
      find_(find ? std::move(find) : FindAddresses(&addresses_of)) {}
DisplayServer::~DisplayServer() = default;
DisplayServer::DisplayServer(DisplayServer&&) noexcept = default;
DisplayServer& DisplayServer::operator=(DisplayServer&&) noexcept = default;

void DisplayServer::connect(std::uint32_t width, std::uint32_t height, Clock::time_point deadline) {
    if (!search_) search_ = std::make_unique<Search>(find_, address_.host);
    std::optional<std::vector<std::string>> addresses;
    try {
        addresses = search_->result(deadline);
    } catch (const std::runtime_error&) {
        search_.reset();
        throw;
    }
    if (!addresses) throw std::runtime_error("no name server answers");  // the search goes on
    search_.reset();
    connection_ = std::make_unique<Connection>(*addresses, address_.port, deadline);
    connection_->send(tev::create_image(name_, width, height), deadline);
}

void DisplayServer::show(std::uint32_t width, std::uint32_t height, std::span<const Rgb> pixels) {
    try {
        const Clock::time_point deadline = Clock::now() + kPatience;
        if (!connection_) connect(width, height, deadline);
        connection_->send(tev::update_image(name_, width, height, pixels), deadline);
    } catch (const std::runtime_error& error) {
        connection_.reset();
        throw std::runtime_error(
            fmt::format("cannot show the image at {}: {}", address_.text(), error.what()));
    }
}

}  // namespace lxs
