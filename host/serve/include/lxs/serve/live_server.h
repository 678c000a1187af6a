// A web server of one page, for this machine alone.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "lxs/serve/board.h"

namespace lxs::serve {

/// Serves the board's render at 127.0.0.1 in a thread of its own, until it is destroyed.
class LiveServer {
  public:
    /// `port` 0: any that is free. Throws std::system_error if it can't listen there. The board
    /// must outlive the server.
    LiveServer(Board& board, std::uint16_t port);
    ~LiveServer();
    LiveServer(const LiveServer&) = delete;
    LiveServer& operator=(const LiveServer&) = delete;

    /// The page's address, with the token without which nothing is answered.
    std::string link() const;

  private:
    class Listener;
    std::unique_ptr<Listener> listener_;
};

}  // namespace lxs::serve
