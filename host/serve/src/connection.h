// One connection of a browser: request after request, each within bounds of size and time.
#pragma once

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/serializer.hpp>
#include <boost/beast/http/span_body.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "routes.h"

namespace lxs::serve {

/// Lives as long as something is under way on it. A request has to be whole within `patience`; an
/// answer may take any time, as long as some of it is read within each `patience`.
class Connection : public std::enable_shared_from_this<Connection> {
  public:
    using Answer = std::function<Reply(const Request&)>;
    /// `ended` is called when the connection is over.
    Connection(boost::asio::ip::tcp::socket socket, std::chrono::milliseconds patience,
               Answer answer, std::function<void(Connection*)> ended);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    void read();
    /// Whether nothing that came on it was admitted yet.
    bool is_strangers() const { return !admitted_; }
    void close();

  private:
    void reply_to_request(const boost::system::error_code& error);
    void unreadable(const boost::system::error_code& error);
    void send(Reply reply, bool keep_alive);
    void send_more();
    void finish();
    void discard();

    using Response = boost::beast::http::response<boost::beast::http::span_body<const char>>;

    boost::beast::tcp_stream stream_;
    std::chrono::milliseconds patience_;
    Answer answer_;
    std::function<void(Connection*)> ended_;
    bool admitted_ = false;
    boost::beast::flat_buffer buffer_;
    std::array<char, 4096> rest_{};  // what follows the last request
    std::optional<RequestParser> parser_;
    Reply reply_;
    Response response_;
    std::optional<boost::beast::http::serializer<false, Response::body_type>> unsent_;
};

}  // namespace lxs::serve
