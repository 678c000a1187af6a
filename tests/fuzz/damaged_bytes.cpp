// Edits of bytes.
#include "damaged_bytes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace fuzz {
namespace {

using Bytes = std::vector<std::byte>;

enum Edit : std::uint8_t { Replace, Double, Float, Count, Insert, Remove, Move, CutOff, Edits };

/// Anywhere, but half of the places are among the first 256 bytes or the last: there are sizes.
std::size_t place(std::size_t size, InputBytes& input) {
    const std::size_t way = input.below(4);
    if (way == 0) return std::min<std::size_t>(input.byte(), size);
    if (way == 1) return size - std::min<std::size_t>(input.byte(), size);
    const std::size_t coarse = input.byte(), fine = input.byte(), finest = input.byte();
    return (coarse << 16 | fine << 8 | finest) % (size + 1);
}

template <class T>
void put(T value, Bytes& bytes, std::size_t at) {
    std::memcpy(bytes.data() + at, &value, std::min(sizeof value, bytes.size() - at));
}

std::ptrdiff_t offset(std::size_t at) {
    return static_cast<std::ptrdiff_t>(at);
}

void edit(Bytes& bytes, InputBytes& input) {
    const auto what = static_cast<Edit>(input.below(Edits));
    const std::size_t at = place(bytes.size(), input);
    const std::size_t length = std::min<std::size_t>(input.byte(), bytes.size() - at);
    const auto first = bytes.begin() + offset(at);
    switch (what) {
        case Replace:
            std::generate_n(first, std::min<std::size_t>(length, 16),
                            [&] { return std::byte(input.byte()); });
            break;
        case Double:
            put(input.number(), bytes, at);
            break;
        case Float:
            put(static_cast<float>(input.number()), bytes, at);
            break;
        case Count:
            put(std::uint64_t{input.byte()} << input.below(64), bytes, at);
            break;
        case Insert:
            bytes.insert(first, length, std::byte(input.byte()));
            break;
        case Remove:
            bytes.erase(first, first + offset(length));
            break;
        case Move:
            std::rotate(bytes.begin(), first, first + offset(length));
            break;
        default:
            bytes.resize(at);
    }
}

}  // namespace

Bytes damaged_bytes(std::span<const std::byte> whole, InputBytes& input) {
    constexpr int kMostEdits = 256;
    Bytes bytes(whole.begin(), whole.end());
    for (int i = 0; i < kMostEdits && !input.empty(); ++i)
        edit(bytes, input);
    return bytes;
}

}  // namespace fuzz
