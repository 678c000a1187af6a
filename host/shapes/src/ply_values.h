// The numbers of a PLY file after its header, one after another.
#pragma once

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "ply_header.h"

namespace lxs {

/// Bytes of a value in a binary file.
inline std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::Int8:
        case PlyType::UInt8:
            return 1;
        case PlyType::Int16:
        case PlyType::UInt16:
            return 2;
        case PlyType::Int32:
        case PlyType::UInt32:
        case PlyType::Float:
            return 4;
        case PlyType::Double:
            break;
    }
    return 8;
}

template <class T>
double binary_value(const char* at, PlyFormat format) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, at, sizeof(T));
    constexpr auto kOwn =
        std::endian::native == std::endian::little ? PlyFormat::LittleEndian : PlyFormat::BigEndian;
    if (format != kOwn) std::reverse(bytes, bytes + sizeof(T));
    return static_cast<double>(std::bit_cast<T>(bytes));
}

/// The value whose size_of(type) bytes begin at `at`; `format` is a binary one.
inline double binary_value(const char* at, PlyType type, PlyFormat format) {
    switch (type) {
        case PlyType::Int8:
            return binary_value<std::int8_t>(at, format);
        case PlyType::UInt8:
            return binary_value<std::uint8_t>(at, format);
        case PlyType::Int16:
            return binary_value<std::int16_t>(at, format);
        case PlyType::UInt16:
            return binary_value<std::uint16_t>(at, format);
        case PlyType::Int32:
            return binary_value<std::int32_t>(at, format);
        case PlyType::UInt32:
            return binary_value<std::uint32_t>(at, format);
        case PlyType::Float:
            return binary_value<float>(at, format);
        case PlyType::Double:
            break;
    }
    return binary_value<double>(at, format);
}

/// Reads values in the file's order. `next` and `take` throw std::runtime_error at the file's end,
/// `next` for text that is no number, too.
class PlyValues {
  public:
    PlyValues(std::string_view data, PlyFormat format)
        : at_(data.data()), end_(data.data() + data.size()), format_(format) {}

    PlyFormat format() const { return format_; }
    std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }
    /// The next `bytes` of a binary file, which are passed over.
    const char* take(std::size_t bytes) {
        if (bytes_left() < bytes) throw_ended();
        return std::exchange(at_, at_ + bytes);
    }
    /// What `take` will give.
    const char* ahead() const { return at_; }

    double next(PlyType type) {
        if (format_ == PlyFormat::Ascii) return next_text();
        return binary_value(take(size_of(type)), type, format_);
    }

  private:
    double next_text() {
        const auto is_blank = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
        while (at_ < end_ && is_blank(*at_))
            ++at_;
        if (at_ == end_) throw_ended();
        if (*at_ == '+') ++at_;
        double value = 0;
        const auto read = std::from_chars(at_, end_, value);
        // Out of range is both too large and too small; only the latter is 0.
        const bool tiny = std::string_view(at_, read.ptr).find("e-") != std::string_view::npos ||
                          std::string_view(at_, read.ptr).find("E-") != std::string_view::npos;
        if (read.ec == std::errc::result_out_of_range && !tiny)
            throw std::runtime_error("its data hold a number beyond all range");
        if (read.ec == std::errc::invalid_argument || (read.ptr < end_ && !is_blank(*read.ptr)))
            throw std::runtime_error("its data hold what is not a number");
        at_ = read.ptr;
        return value;
    }

    [[noreturn]] static void throw_ended() {
        throw std::runtime_error("it ends before its last element");
    }

    const char* at_;
    const char* end_;
    PlyFormat format_;
};

}  // namespace lxs
