// The state that a render carries from pass to pass, saved into a checkpoint and restored from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace lxs {

/// A checkpoint's content that doesn't fit what is to be restored from it.
class StateError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What an archive takes as its bytes: numbers, enumerations and structures without padding, which
/// would hold arbitrary bytes. Structures that hold floats are saved member by member.
template <class T>
concept PlainState =
    std::is_trivially_copyable_v<T> && !std::is_pointer_v<T> && !std::is_same_v<T, bool> &&
    (std::is_same_v<T, float> || std::is_same_v<T, double> ||
     std::has_unique_object_representations_v<T>);

/// Saves or restores, so that one function `state(StateArchive&)` of a class describes both:
///
///     void Chain::state(lxs::StateArchive& archive) {
///         archive.value(mutations_);
///         archive.values(coordinates_);
///     }
///
/// Everything restored may have been written by anyone: what it says of sizes and indices has to be
/// checked before it is used, by means of StateError.
class StateArchive {
  public:
    virtual ~StateArchive() = default;
    virtual bool restoring() const = 0;
    /// Saves `data`, or fills it; throws StateError past the end.
    virtual void bytes(std::span<std::byte> data) = 0;
    /// Bytes left to restore; 0 while saving.
    virtual std::size_t remaining() const = 0;

    template <PlainState T>
    void value(T& value) {
        bytes(std::as_writable_bytes(std::span(&value, 1)));
    }
    void value(bool& value);

    /// A vector of any length: its size, then its elements. Restoring allocates no more than there
    /// are bytes left.
    template <PlainState T>
    void values(std::vector<T>& values) {
        values.resize(count(values.size(), sizeof(T)));
        bytes(std::as_writable_bytes(std::span(values)));
    }
    void text(std::string& text);

    /// Elements whose number both sides know; throws StateError if another number was saved.
    template <PlainState T, std::size_t extent>
    void fixed(std::span<T, extent> values) {
        expect_count(values.size(), sizeof(T));
        bytes(std::as_writable_bytes(values));
    }
    template <PlainState T>
    void fixed(std::vector<T>& values) {
        fixed(std::span(values));
    }

    /// Saves `size`, or gives the size that was saved, of a sequence of which each element takes at
    /// least `element_bytes` > 0; throws StateError if more than the bytes that are left.
    std::size_t count(std::size_t size, std::size_t element_bytes);

  private:
    void expect_count(std::size_t size, std::size_t element_bytes);
};

}  // namespace lxs
