// Chunks of the bump allocator.
#include "aips/core/base/arena.h"

#include <algorithm>
#include <cstdint>

namespace aips {

std::size_t Arena::bytes_reserved() const {
    std::size_t bytes = 0;
    for (const Chunk& chunk : chunks_)
        bytes += chunk.size;
    return bytes;
}

void* Arena::bump(std::size_t bytes, std::size_t alignment) {
    const Chunk& chunk = chunks_[at_.chunk];
    const auto base = reinterpret_cast<std::uintptr_t>(chunk.memory.get());
    const std::size_t start = ((base + at_.offset + alignment - 1) & ~(alignment - 1)) - base;
    if (start > chunk.size || bytes > chunk.size - start) return nullptr;
    at_.offset = start + bytes;
    return chunk.memory.get() + start;
}

void* Arena::do_allocate(std::size_t bytes, std::size_t alignment) {
    for (; at_.chunk < chunks_.size(); ++at_.chunk, at_.offset = 0) {
        if (void* memory = bump(bytes, alignment)) return memory;
    }
    const std::size_t size = std::max(chunk_bytes_, bytes + alignment);
    chunks_.push_back({std::make_unique_for_overwrite<std::byte[]>(size), size});
    return bump(bytes, alignment);
}

}  // namespace aips
