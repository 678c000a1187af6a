// A web server of one page, for this machine alone.
#include "lxs/serve/live_server.h"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/system/system_error.hpp>
#include <chrono>
#include <exception>
#include <list>
#include <system_error>
#include <thread>

#include "access.h"
#include "connection.h"

namespace lxs::serve {

using boost::asio::ip::tcp;

class LiveServer::Listener {
  public:
    Listener(Board& board, std::uint16_t port, std::chrono::milliseconds patience)
        : board_(board),
          patience_(patience),
          acceptor_(context_, {boost::asio::ip::address_v4::loopback(), port}),
          access_(random_token(), acceptor_.local_endpoint().port()) {
        accept();
        thread_ = std::thread([this] { run(); });
    }
    ~Listener() {
        context_.stop();
        thread_.join();
    }
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    std::string link() const { return access_.link(); }

  private:
    /// Browsers open six to a server; a few pages may watch at once.
    static constexpr std::size_t kMostConnections = 32;

    void run() {
        while (!context_.stopped()) {
            try {
                context_.run();
            } catch (const std::exception&) {
                // No memory for a connection: it is gone, the others go on.
            }
        }
    }
    void accept() {
        acceptor_.async_accept([this](const boost::system::error_code& error, tcp::socket socket) {
            if (error) return accept_later();
            accept();
            if (connections_.size() >= kMostConnections) leave_a_stranger();
            if (connections_.size() < kMostConnections) serve(std::move(socket));
        });
    }
    /// Closes the oldest connection that has not shown the token: whoever does not know it must
    /// not take the places of those who do.
    void leave_a_stranger() {
        const auto stranger = std::find_if(connections_.begin(), connections_.end(),
                                           [](const Connection* c) { return c->is_strangers(); });
        if (stranger == connections_.end()) return;
        Connection* const connection = *stranger;
        connections_.erase(stranger);
        connection->close();
    }
    /// There are no descriptors left, or the like.
    void accept_later() {
        pause_.expires_after(std::chrono::seconds(1));
        pause_.async_wait([this](const boost::system::error_code&) { accept(); });
    }
    void serve(tcp::socket socket) {
        const auto answer_request = [this](const Request& request) {
            return answer(request, access_, board_);
        };
        const auto connection =
            std::make_shared<Connection>(std::move(socket), patience_, answer_request,
                                         [this](Connection* ended) { connections_.remove(ended); });
        connections_.push_back(connection.get());
        connection->read();
    }

    Board& board_;
    std::chrono::milliseconds patience_;
    /// The oldest first; before the context, whose end takes connections with it.
    std::list<Connection*> connections_;
    boost::asio::io_context context_{1};
    boost::asio::steady_timer pause_{context_};
    tcp::acceptor acceptor_;
    Access access_;
    std::thread thread_;
};

LiveServer::LiveServer(Board& board, std::uint16_t port, std::chrono::milliseconds patience) try
    : listener_(std::make_unique<Listener>(board, port, patience)) {
} catch (const boost::system::system_error& error) {
    throw std::system_error(error.code());
}
LiveServer::~LiveServer() = default;

std::string LiveServer::link() const {
    return listener_->link();
}

}  // namespace lxs::serve
