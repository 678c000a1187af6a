// What each request is answered with.
#pragma once

#include <boost/beast/http/status.hpp>
#include <string_view>

#include "access.h"
#include "lxs/serve/board.h"
#include "request.h"

namespace lxs::serve {

struct Reply {
    boost::beast::http::status status = boost::beast::http::status::ok;
    std::string_view type = "text/plain; charset=utf-8";
    Bytes body;
};

/// The page, its state, its pictures, and orders; there is nothing else, and no file is read:
/// GET "", "state", "image", "layer/NUMBER" ("layer/none": no more), POST "pause", "resume",
/// "stop".
Reply answer(const Request& request, const Access& access, Board& board);

/// For a request that can't be read.
Reply refusal(boost::beast::http::status status);

}  // namespace lxs::serve
