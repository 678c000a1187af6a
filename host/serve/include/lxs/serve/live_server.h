// A web server of one page, for this machine alone.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "lxs/serve/board.h"

namespace lxs::serve {

/// A page asks twice a second; what is silent for longer is closed.
inline constexpr std::chrono::seconds kPatience{15};

/// Whether browsers open pages at this port. They refuse those of other services, as of mail, that
/// a page could be made to talk to (https://fetch.spec.whatwg.org/#port-blocking).
bool browsers_open(std::uint16_t port);

/// Serves the board's render at 127.0.0.1 in a thread of its own, until it is destroyed.
class LiveServer {
  public:
    /// `port` 0: any that is free. Throws std::system_error if it can't listen there. The board
    /// must outlive the server. Who sends or reads nothing for `patience` is left.
    LiveServer(Board& board, std::uint16_t port, std::chrono::milliseconds patience = kPatience);
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
