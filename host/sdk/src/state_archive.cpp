// The state that a render carries from pass to pass, saved into a checkpoint and restored from it.
#include "lxs/sdk/state_archive.h"

namespace lxs {

void StateArchive::value(bool& value) {
    std::uint8_t byte = value ? 1 : 0;
    this->value(byte);
    if (byte > 1) throw StateError("a truth value is neither 0 nor 1");
    value = byte == 1;
}

void StateArchive::text(std::string& text) {
    text.resize(count(text.size(), 1));
    bytes(std::as_writable_bytes(std::span(text)));
}

std::size_t StateArchive::count(std::size_t size, std::size_t element_bytes) {
    std::uint64_t saved = size;
    value(saved);
    if (restoring() && saved > remaining() / element_bytes) {
        throw StateError("it says that it holds more than there is: " + std::to_string(saved) +
                         " elements of " + std::to_string(element_bytes) + " bytes");
    }
    return static_cast<std::size_t>(saved);
}

void StateArchive::expect_count(std::size_t size, std::size_t element_bytes) {
    const std::size_t saved = count(size, element_bytes);
    if (saved != size) {
        throw StateError("it holds " + std::to_string(saved) + " elements where there are " +
                         std::to_string(size));
    }
}

}  // namespace lxs
