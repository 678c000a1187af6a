// Turns the bytes of a fuzzer into the values that a target wants.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fuzz {

/// Bytes from first to last; when they are used up, zeros.
class InputBytes {
  public:
    InputBytes(const std::uint8_t* data, std::size_t size)
        : at_(data == nullptr ? "" : reinterpret_cast<const char*>(data), size) {}

    bool empty() const { return at_.empty(); }
    std::uint8_t byte();
    /// In [0, n); n > 0.
    std::size_t below(std::size_t n);
    /// A number as scene files can hold: finite, at most 3.4e38 in absolute value. Often one at an
    /// edge of some type, or a small one.
    double number();
    /// Up to `most` bytes.
    std::string text(std::size_t most);
    /// All that is left.
    std::string_view rest() const { return at_; }

  private:
    std::string_view at_;
};

}  // namespace fuzz
