// What stands between a render and those who watch it: the image so far, and what they ask for.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>

namespace lxs::serve {

/// Bytes that go out as they are; shared, as they may be on their way when new ones come.
using Bytes = std::shared_ptr<const std::string>;

/// A picture as watchers get it: width, height, channels and number, each 32 bits, then
/// width * height * channels floats, row by row; all little endian.
Bytes picture_bytes(std::uint32_t width, std::uint32_t height, std::uint32_t channels,
                    std::uint32_t number, std::span<const float> values);

/// What watchers have asked for.
struct Orders {
    bool pause = false;
    bool stop = false;
};

/// The render's thread puts up what is to be seen and reads the orders; the server's thread hands
/// out and notes. Every call may come from any thread.
class Board {
  public:
    // The render's side.

    /// Whether anybody has asked for the state lately: nothing need be put up for nobody.
    bool watched() const;
    /// The layer that watchers want to see; none if they want none, or nobody watches.
    std::optional<std::size_t> wanted_layer() const;
    /// `state`: a JSON value.
    void put_state(std::string state);
    /// Each picture has a number greater than the one before; 0 is no picture.
    void put_image(Bytes picture, std::uint32_t number);
    void put_layer(std::size_t layer, Bytes picture, std::uint32_t number);
    Orders orders() const;
    /// Until there is a new order or watchers want another layer, at most `longest`.
    void wait_for_wishes(std::chrono::milliseconds longest);
    /// Until a watcher has got the state and the image that were put up last, at most `longest`; at
    /// once if nobody watches.
    void wait_until_seen(std::chrono::milliseconds longest);

    // The server's side.

    /// JSON: orders, numbers of the pictures, and the render's own state as "render".
    Bytes state();
    /// Null if there is none yet.
    Bytes image();
    /// Notes the wish; null if there is no picture of this layer yet.
    Bytes layer(std::size_t layer);
    void no_layer();
    void order(const Orders& orders);

  private:
    using Clock = std::chrono::steady_clock;
    bool watched_now() const;

    struct Picture {
        Bytes bytes;
        std::uint32_t number = 0;
    };

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::string state_ = "null";
    Picture image_, layer_;
    std::size_t layer_shown_ = 0;
    std::optional<std::size_t> wanted_;
    Orders orders_;
    std::uint64_t wishes_ = 0;
    std::optional<Clock::time_point> asked_;  ///< for the state, last
    bool state_seen_ = false, image_seen_ = false;
};

}  // namespace lxs::serve
