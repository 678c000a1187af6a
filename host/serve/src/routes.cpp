// What each request is answered with.
#include "routes.h"

#include <charconv>

#include "lxs/serve/page.h"

namespace lxs::serve {
namespace {

namespace http = boost::beast::http;

Reply of_text(http::status status, std::string text) {
    return {.status = status, .body = std::make_shared<std::string>(std::move(text))};
}

Reply picture(Bytes bytes) {
    if (!bytes) return of_text(http::status::no_content, {});
    return {.type = "application/octet-stream", .body = std::move(bytes)};
}

Reply layer(std::string_view name, Board& board) {
    if (name == "none") {
        board.no_layer();
        return of_text(http::status::no_content, {});
    }
    std::uint32_t number = 0;
    const char* const end = name.data() + name.size();
    const auto [rest, error] = std::from_chars(name.data(), end, number);
    if (error != std::errc() || rest != end) return refusal(http::status::not_found);
    return picture(board.layer(number));
}

Reply show(std::string_view what, Board& board) {
    constexpr std::string_view kLayer = "layer/";
    if (what.empty()) {
        return {.type = "text/html; charset=utf-8",
                .body = std::make_shared<std::string>(page_text())};
    }
    if (what == "state") return {.type = "application/json", .body = board.state()};
    if (what == "image") return picture(board.image());
    if (what.starts_with(kLayer)) return layer(what.substr(kLayer.size()), board);
    return refusal(http::status::not_found);
}

Reply take_order(std::string_view what, Board& board) {
    if (what == "pause") {
        board.order({.pause = true});
    } else if (what == "resume") {
        board.order({});
    } else if (what == "stop") {
        board.order({.stop = true});
    } else {
        return refusal(http::status::not_found);
    }
    return {.type = "application/json", .body = board.state()};
}

}  // namespace

Reply refusal(http::status status) {
    const auto reason = http::obsolete_reason(status);
    return of_text(status, std::string(reason.data(), reason.size()) + "\n");
}

Reply answer(const Request& request, const Access& access, Board& board) {
    const auto what = access.admitted(request);
    if (!what) return refusal(http::status::forbidden);
    if (request.method() == http::verb::get) return show(*what, board);
    if (request.method() == http::verb::post) return take_order(*what, board);
    return refusal(http::status::method_not_allowed);
}

}  // namespace lxs::serve
