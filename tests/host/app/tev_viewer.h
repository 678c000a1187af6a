// A stand-in for the viewer tev: listens, and keeps what it is sent, as tev's own reader does.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "tev_reader.h"

namespace lxs::test {

class TevViewer {
  public:
    /// Listens on a free port. `hang_up_after`: packets after which it ends the first connection
    /// and waits for another; 0: never.
    explicit TevViewer(int hang_up_after = 0);
    ~TevViewer();
    TevViewer(const TevViewer&) = delete;
    TevViewer& operator=(const TevViewer&) = delete;

    std::string address() const;
    /// What has come when the sender has hung up, by name. Waits for that.
    std::map<std::string, ShownImage> images();
    int connections() const;

  private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace lxs::test
