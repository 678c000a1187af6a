// Archives for what ranks tell each other: builds of one program on machines of one kind, which
// need not doubt each other's bytes.
#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

#include "aips/core/base/state_archive.h"
#include "base/parallel_for.h"

namespace aips {

/// `from` to the beginning of `to`; one thread does not fill the memory's bandwidth.
inline void copy_on_all_threads(std::span<const std::byte> from, std::span<std::byte> to) {
    constexpr std::size_t kBytesPerJob = std::size_t{1} << 18;
    if (from.size() <= kBytesPerJob) {
        if (!from.empty()) std::memcpy(to.data(), from.data(), from.size());
        return;
    }
    in_chunks(from.size(), kBytesPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        std::memcpy(to.data() + first, from.data() + first, last - first);
    });
}

/// Counts what a part would take.
class RankMeasure final : public StateArchive {
  public:
    bool restoring() const override { return false; }
    void bytes(std::span<std::byte> data) override { size_ += data.size(); }
    std::size_t remaining() const override { return 0; }
    std::size_t size() const { return size_; }

  private:
    std::size_t size_ = 0;
};

/// Writes a part where it was measured to fit.
class RankWriter final : public StateArchive {
  public:
    explicit RankWriter(std::span<std::byte> message) : rest_(message) {}
    bool restoring() const override { return false; }
    void bytes(std::span<std::byte> data) override {
        check(data.size() <= rest_.size(), "a part grew while it was told");
        copy_on_all_threads(data, rest_);
        rest_ = rest_.subspan(data.size());
    }
    std::size_t remaining() const override { return rest_.size(); }

  private:
    std::span<std::byte> rest_;
};

/// Reads one, from bytes that outlive it.
class RankReader final : public StateArchive {
  public:
    explicit RankReader(std::span<const std::byte> message) : rest_(message) {}
    bool restoring() const override { return true; }
    void bytes(std::span<std::byte> data) override {
        check(data.size() <= rest_.size(), "ranks do not have the same work");
        copy_on_all_threads(rest_.first(data.size()), data);
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
