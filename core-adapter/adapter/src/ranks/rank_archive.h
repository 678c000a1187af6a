// Archives for what ranks tell each other: builds of one program on machines of one kind, which
// need not doubt each other's bytes.
#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

#include "aips/core/base/state_archive.h"

namespace aips {

/// Collects a message.
class RankWriter final : public StateArchive {
  public:
    RankWriter() { message_.reserve(kUsualBytes); }
    bool restoring() const override { return false; }
    void bytes(std::span<std::byte> data) override {
        message_.insert(message_.end(), data.begin(), data.end());
    }
    std::size_t remaining() const override { return 0; }
    std::span<const std::byte> message() const { return message_; }

  private:
    /// Of an iteration: to grow to it bit by bit would copy it several times.
    static constexpr std::size_t kUsualBytes = std::size_t{1} << 20;

    std::vector<std::byte> message_;
};

/// Reads one, which outlives it.
class RankReader final : public StateArchive {
  public:
    explicit RankReader(std::span<const std::byte> message) : rest_(message) {}
    bool restoring() const override { return true; }
    void bytes(std::span<std::byte> data) override {
        check(data.size() <= rest_.size(), "ranks do not have the same work");
        if (!data.empty()) std::memcpy(data.data(), rest_.data(), data.size());
        rest_ = rest_.subspan(data.size());
    }
    std::size_t remaining() const override { return rest_.size(); }

  private:
    std::span<const std::byte> rest_;
};

/// Elements as they lie in memory, padding included: what is saved to files must not be. Both sides
/// know how many there are.
template <class T>
requires std::is_trivially_copyable_v<T>
void plain(StateArchive& archive, std::span<T> values) {
    archive.bytes(std::as_writable_bytes(values));
}

/// Likewise of a vector of any length.
template <class T>
requires std::is_trivially_copyable_v<T>
void plain(StateArchive& archive, std::vector<T>& values) {
    values.resize(archive.count(values.size(), sizeof(T)));
    plain(archive, std::span<T>(values));
}

/// Saves or restores each: a vector, a number, or what has a state().
template <class... Values>
void state_of(StateArchive& archive, Values&... values) {
    const auto one = [&]<class T>(T& value) {
        if constexpr (requires { value.state(archive); }) {
            value.state(archive);
        } else if constexpr (StateNumber<T>) {
            archive.value(value);
        } else {
            plain(archive, value);
        }
    };
    (one(values), ...);
}

}  // namespace aips
