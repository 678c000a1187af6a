// What stands between a render and those who watch it.
#include "lxs/serve/board.h"

#include <array>
#include <bit>
#include <cstring>

namespace lxs::serve {
namespace {

/// A page asks twice a second; browsers slow down what is in the background to once a second.
constexpr std::chrono::seconds kStillWatching{5};

static_assert(std::endian::native == std::endian::little, "pictures go out as they lie in memory");

}  // namespace

Bytes picture_bytes(std::uint32_t width, std::uint32_t height, std::uint32_t channels,
                    std::uint32_t number, std::span<const float> values) {
    const std::array head{width, height, channels, number};
    auto bytes = std::make_shared<std::string>(sizeof head + values.size_bytes(), '\0');
    std::memcpy(bytes->data(), head.data(), sizeof head);
    if (!values.empty())
        std::memcpy(bytes->data() + sizeof head, values.data(), values.size_bytes());
    return bytes;
}

bool Board::watched_now() const {
    return asked_ && Clock::now() - *asked_ < kStillWatching;
}

bool Board::watched() const {
    const std::lock_guard lock(mutex_);
    return watched_now();
}

std::optional<std::size_t> Board::wanted_layer() const {
    const std::lock_guard lock(mutex_);
    return watched_now() ? wanted_ : std::nullopt;
}

void Board::put_state(std::string state) {
    const std::lock_guard lock(mutex_);
    state_ = std::move(state);
    state_seen_ = false;
}

void Board::put_image(Bytes picture, std::uint32_t number) {
    const std::lock_guard lock(mutex_);
    image_ = {std::move(picture), number};
    image_seen_ = false;
}

void Board::put_layer(std::size_t layer, Bytes picture, std::uint32_t number) {
    const std::lock_guard lock(mutex_);
    layer_ = {std::move(picture), number};
    layer_shown_ = layer;
}

Orders Board::orders() const {
    const std::lock_guard lock(mutex_);
    return orders_;
}

void Board::wait_for_wishes(std::chrono::milliseconds longest) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, longest, [&, before = wishes_] { return wishes_ != before; });
}

void Board::wait_until_seen(std::chrono::milliseconds longest) {
    std::unique_lock lock(mutex_);
    if (!watched_now()) return;
    changed_.wait_for(lock, longest,
                      [&] { return state_seen_ && (image_seen_ || image_.number == 0); });
}

Bytes Board::state() {
    const std::lock_guard lock(mutex_);
    asked_ = Clock::now();
    state_seen_ = true;
    changed_.notify_all();
    const auto truth = [](bool value) { return value ? "true" : "false"; };
    return std::make_shared<std::string>(
        std::string("{\"pause\":") + truth(orders_.pause) + ",\"stop\":" + truth(orders_.stop) +
        ",\"image\":" + std::to_string(image_.number) +
        ",\"layer\":" + std::to_string(layer_shown_) +
        ",\"layer image\":" + std::to_string(layer_.number) + ",\"render\":" + state_ + "}");
}

Bytes Board::image() {
    const std::lock_guard lock(mutex_);
    image_seen_ = true;
    changed_.notify_all();
    return image_.bytes;
}

Bytes Board::layer(std::size_t layer) {
    const std::lock_guard lock(mutex_);
    if (wanted_ != layer) {
        wanted_ = layer;
        ++wishes_;
        changed_.notify_all();
    }
    return layer_.bytes && layer_shown_ == layer ? layer_.bytes : nullptr;
}

void Board::no_layer() {
    const std::lock_guard lock(mutex_);
    wanted_.reset();
}

void Board::order(const Orders& orders) {
    const std::lock_guard lock(mutex_);
    orders_ = {orders.pause, orders_.stop || orders.stop};
    ++wishes_;
    changed_.notify_all();
}

}  // namespace lxs::serve
