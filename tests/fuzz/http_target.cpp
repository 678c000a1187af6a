// Fuzz target: bytes that come to the server of --serve, from the reader of HTTP to the answer. The
// token is 32 zeros, the port 8080.
#include <boost/asio/buffer.hpp>
#include <cstdlib>
#include <string>
#include <string_view>

#include "fuzz_target.h"
#include "routes.h"

namespace {

using boost::beast::http::status;

/// Reads a request as a connection does; false if it is none.
bool read(lxs::serve::RequestParser& parser, std::string_view bytes) {
    lxs::serve::bound(parser);
    parser.eager(true);
    boost::system::error_code error;
    while (!error && !parser.is_done() && !bytes.empty()) {
        const std::size_t taken =
            parser.put(boost::asio::buffer(bytes.data(), bytes.size()), error);
        if (taken == 0) break;
        bytes.remove_prefix(taken);
    }
    return !error && parser.is_done();
}

void check(const lxs::serve::Request& request, const lxs::serve::Reply& reply,
           const lxs::serve::Board& board) {
    if (!reply.body) std::abort();
    const bool admitted = reply.status != status::forbidden;
    const std::string token(32, '0');
    const auto target = request.target();
    const bool knows =
        std::string_view(target.data(), target.size()).starts_with("/" + token + "/");
    if (admitted && !knows) std::abort();
    const bool ordered = board.orders().stop || board.orders().pause;
    const bool may_order = admitted && request.count("Origin") == 1 &&
                           request.method() == boost::beast::http::verb::post;
    if (ordered && !may_order) std::abort();
    if (!admitted && board.watched()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const lxs::serve::Access access(std::string(32, '0'), 8080);
    lxs::serve::Board board;
    lxs::serve::RequestParser parser;
    if (!read(parser, {reinterpret_cast<const char*>(data), data ? size : 0})) return 0;
    const lxs::serve::Reply reply = lxs::serve::answer(parser.get(), access, board);
    check(parser.get(), reply, board);
    return 0;
}
