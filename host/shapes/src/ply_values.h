// The numbers of a PLY file after its header, one after another.
#pragma once

#include <bit>
#include <charconv>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "ply_header.h"

namespace lxs {

/// Reads values in the file's order. `next` throws std::runtime_error at the file's end and for
/// text that is no number.
class PlyValues {
  public:
    PlyValues(std::string_view data, PlyFormat format)
        : at_(data.data()), end_(data.data() + data.size()), format_(format) {}

    double next(PlyType type) {
        if (format_ == PlyFormat::Ascii) return next_text();
        switch (type) {
            case PlyType::Int8:
                return binary<std::int8_t>();
            case PlyType::UInt8:
                return binary<std::uint8_t>();
            case PlyType::Int16:
                return binary<std::int16_t>();
            case PlyType::UInt16:
                return binary<std::uint16_t>();
            case PlyType::Int32:
                return binary<std::int32_t>();
            case PlyType::UInt32:
                return binary<std::uint32_t>();
            case PlyType::Float:
                return binary<float>();
            case PlyType::Double:
                break;
        }
        return binary<double>();
    }

  private:
    template <class T>
    double binary() {
        if (static_cast<std::size_t>(end_ - at_) < sizeof(T)) throw_ended();
        char bytes[sizeof(T)];
        std::memcpy(bytes, at_, sizeof(T));
        at_ += sizeof(T);
        constexpr auto kOwn = std::endian::native == std::endian::little ? PlyFormat::LittleEndian
                                                                         : PlyFormat::BigEndian;
        if (format_ != kOwn) {
            for (std::size_t i = 0; i < sizeof(T) / 2; ++i)
                std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
        }
        return static_cast<double>(std::bit_cast<T>(bytes));
    }

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
