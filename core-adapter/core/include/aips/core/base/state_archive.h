// The state that a render carries from pass to pass, saved and restored by the same functions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace aips {

/// What is restored does not fit what it is restored into, or is damaged.
class StateError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What is saved as its bytes: numbers and enumerations. Structures are saved member by member, as
/// padding would hold arbitrary bytes.
template <class T>
concept StateNumber = std::is_floating_point_v<T> || std::is_enum_v<T> ||
    (std::is_integral_v<T> && !std::is_same_v<T, bool>);

/// Saves or restores, so that one function `void state(StateArchive&)` of a class describes both.
/// Numbers have the machine's own layout.
///
/// What is restored may have been written by anyone: functions check all that later code relies on
/// and throw StateError. What failed to restore is to be dropped.
class StateArchive {
  public:
    virtual ~StateArchive() = default;
    virtual bool restoring() const = 0;
    /// Saves `data`, or fills it; throws StateError past the end.
    virtual void bytes(std::span<std::byte> data) = 0;
    /// Bytes left to restore.
    virtual std::size_t remaining() const = 0;

    template <StateNumber T>
    void value(T& value) {
        bytes(std::as_writable_bytes(std::span(&value, 1)));
    }
    void value(bool& value);

    /// An enumeration whose values are 0 .. `last`.
    template <class Enum>
    requires std::is_enum_v<Enum>
    void value(Enum& value, Enum last) {
        this->value(value);
        check(value <= last, "an unknown kind");
    }

    /// A sum of what is not negative, or a count: finite and >= 0.
    void amount(float& value);
    void amount(double& value);
    template <class T, std::size_t n>
    void amounts(std::array<T, n>& values) {
        for (T& value : values)
            amount(value);
    }

    /// A vector of any length: its size, then its elements. Restoring allocates no more than there
    /// are bytes left.
    template <StateNumber T>
    void values(std::vector<T>& values) {
        values.resize(count(values.size(), sizeof(T)));
        bytes(std::as_writable_bytes(std::span(values)));
    }
    /// Elements whose number both sides know; throws StateError if another number was saved.
    template <StateNumber T>
    void fixed(std::span<T> values) {
        fixed_count(values.size());
        bytes(std::as_writable_bytes(values));
    }
    template <StateNumber T>
    void fixed(std::vector<T>& values) {
        fixed(std::span<T>(values));
    }

    /// Saves `size`, or gives the size that was saved, of a sequence of which each element takes at
    /// least `element_bytes` > 0; throws StateError if these are more than the bytes that are left.
    std::size_t count(std::size_t size, std::size_t element_bytes);
    /// Throws StateError if another size was saved.
    void fixed_count(std::size_t size);
    /// Something that both sides know, such as a setting: throws StateError if another was saved.
    template <StateNumber T>
    void same(T value, const char* what) {
        T saved = value;
        this->value(saved);
        if (saved != value) refuse_other(what);
    }

    /// Throws StateError unless it holds: `complaint` tells what is wrong with the state.
    static void check(bool holds, const char* complaint) {
        if (!holds) refuse(complaint);
    }

  private:
    [[noreturn]] static void refuse(const char* complaint);
    [[noreturn]] static void refuse_other(const char* what);
};

}  // namespace aips
