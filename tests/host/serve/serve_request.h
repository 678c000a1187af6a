// Requests as the page of --serve makes them.
#pragma once

#include <string>

#include "request.h"

namespace lxs::serve::test {

inline constexpr const char* kToken = "0123456789abcdef0123456789abcdef";
inline constexpr std::uint16_t kPort = 8080;

inline Request get(const std::string& what) {
    Request request(boost::beast::http::verb::get, std::string("/") + kToken + "/" + what, 11);
    request.set("Host", "127.0.0.1:8080");
    return request;
}

inline Request post(const std::string& what) {
    Request request = get(what);
    request.method(boost::beast::http::verb::post);
    request.set("Origin", "http://127.0.0.1:8080");
    return request;
}

}  // namespace lxs::serve::test
