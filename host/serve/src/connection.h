// One connection of a browser: request after request, each within bounds of size and time.
#pragma once

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/span_body.hpp>
#include <functional>
#include <memory>
#include <optional>

#include "routes.h"

namespace lxs::serve {

/// Lives as long as something is under way on it.
class Connection : public std::enable_shared_from_this<Connection> {
  public:
    using Answer = std::function<Reply(const Request&)>;
    /// `ended` is called when the connection is over.
    Connection(boost::asio::ip::tcp::socket socket, Answer answer, std::function<void()> ended);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    void read();

  private:
    void reply_to_request(const boost::system::error_code& error);
    void unreadable(const boost::system::error_code& error);
    void send(Reply reply, bool keep_alive);
    void finish();
    void discard();
    void close();

    boost::beast::tcp_stream stream_;
    Answer answer_;
    std::function<void()> ended_;
    boost::beast::flat_buffer buffer_;
    std::array<char, 4096> rest_{};  // what follows the last request
    std::optional<RequestParser> parser_;
    Reply reply_;
    boost::beast::http::response<boost::beast::http::span_body<const char>> response_;
};

}  // namespace lxs::serve
