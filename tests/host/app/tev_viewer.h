// A stand-in for the viewer tev: listens, and keeps what it is sent, as tev's own reader does.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lxs::test {

struct ShownImage {
    std::int32_t width = 0, height = 0;
    std::vector<std::string> channels;
    std::vector<std::vector<float>> values;  ///< by channel, row by row
    int created = 0, updates = 0;
};

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
