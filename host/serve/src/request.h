// Requests as they are read, and the bounds within which they are.
#pragma once

#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/parser.hpp>
#include <cstdint>

namespace lxs::serve {

/// No order has a body, nor has a question.
using Request = boost::beast::http::request<boost::beast::http::empty_body>;
using RequestParser = boost::beast::http::request_parser<boost::beast::http::empty_body>;

/// Bytes of a request before its body; a browser's take a tenth.
inline constexpr std::uint32_t kLongestHeader = 8192;

/// Makes `parser` refuse what is longer than any request of the page.
inline void bound(RequestParser& parser) {
    parser.header_limit(kLongestHeader);
    parser.body_limit(0);
}

}  // namespace lxs::serve
