// One connection of a browser: request after request, each within bounds of size and time.
#include "connection.h"

#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>

#include "lxs/serve/page.h"

namespace lxs::serve {
namespace {

namespace http = boost::beast::http;
using http::field;

/// Until whoever has got the last answer hangs up.
constexpr std::chrono::seconds kPatienceAtTheEnd{2};

http::status status_of(const boost::system::error_code& error) {
    if (error == http::error::header_limit) return http::status::request_header_fields_too_large;
    if (error == http::error::body_limit || error == http::error::unexpected_body)
        return http::status::payload_too_large;
    return http::status::bad_request;
}

/// Nothing is kept by a browser, shown inside of another page or handed to other sites.
void set_rules(http::fields& fields) {
    const std::string_view policy = page_policy();
    fields.set("Content-Security-Policy", {policy.data(), policy.size()});
    fields.set("X-Content-Type-Options", "nosniff");
    fields.set("X-Frame-Options", "DENY");
    fields.set("Referrer-Policy", "no-referrer");
    fields.set("Cross-Origin-Resource-Policy", "same-origin");
    fields.set("Cross-Origin-Opener-Policy", "same-origin");
    fields.set(field::cache_control, "no-store");
}

}  // namespace

Connection::Connection(boost::asio::ip::tcp::socket socket, std::chrono::milliseconds patience,
                       Answer answer, std::function<void(Connection*)> ended)
    : stream_(std::move(socket)),
      patience_(patience),
      answer_(std::move(answer)),
      ended_(std::move(ended)),
      buffer_(std::size_t{2} * kLongestHeader) {}

Connection::~Connection() {
    ended_(this);
}

void Connection::read() {
    parser_.emplace();
    bound(*parser_);
    stream_.expires_after(patience_);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](const auto& error, std::size_t) {
                         self->reply_to_request(error);
                     });
}

/// What is no HTTP is answered; who is gone, or silent, is not.
void Connection::unreadable(const boost::system::error_code& error) {
    const bool gone = error == boost::beast::error::timeout ||
                      error == http::error::end_of_stream ||
                      error.category() == boost::asio::error::get_system_category();
    if (gone) return close();
    send(refusal(status_of(error)), false);
}

void Connection::reply_to_request(const boost::system::error_code& error) try {
    if (error) return unreadable(error);
    const Request& request = parser_->get();
    Reply reply = answer_(request);
    admitted_ |= reply.status != http::status::forbidden;
    send(std::move(reply), admitted_ && request.keep_alive());
} catch (const std::exception&) {
    close();  // no memory: the render matters more
}

void Connection::send(Reply reply, bool keep_alive) {
    reply_ = std::move(reply);
    response_ = {};
    response_.result(reply_.status);
    set_rules(response_);
    response_.keep_alive(keep_alive);
    if (reply_.status != http::status::no_content) {
        response_.set(field::content_type, {reply_.type.data(), reply_.type.size()});
        response_.body() = {reply_.body->data(), reply_.body->size()};
        response_.prepare_payload();
    }
    unsent_.emplace(response_);
    send_more();
}

/// Part by part: whoever reads slowly gets all of it, whoever reads nothing is left.
void Connection::send_more() {
    stream_.expires_after(patience_);
    http::async_write_some(stream_, *unsent_,
                           [self = shared_from_this()](const auto& error, std::size_t) {
                               if (error) return self->close();
                               if (!self->unsent_->is_done()) return self->send_more();
                               self->response_.keep_alive() ? self->read() : self->finish();
                           });
}

/// What is closed with something unread is reset, and the answer may be lost with it.
void Connection::finish() {
    boost::system::error_code ignored;
    stream_.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
    stream_.expires_after(kPatienceAtTheEnd);
    discard();
}

void Connection::discard() {
    stream_.async_read_some(boost::asio::buffer(rest_),
                            [self = shared_from_this()](const auto& error, std::size_t) {
                                error ? self->close() : self->discard();
                            });
}

void Connection::close() {
    boost::system::error_code ignored;
    stream_.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
    stream_.socket().close(ignored);
}

}  // namespace lxs::serve
