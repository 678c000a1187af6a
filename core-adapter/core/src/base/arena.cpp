// Chunks of the bump allocator.
#include "aips/core/base/arena.h"

#include <algorithm>

namespace aips {

std::size_t Arena::bytes_reserved() const {
    std::size_t bytes = 0;
    for (const Chunk& chunk : chunks_)
        bytes += chunk.size;
    return bytes;
}

void* Arena::bump(std::size_t bytes, std::size_t alignment) {
    const Chunk& chunk = chunks_[at_.chunk];
    void* start = chunk.memory.get() + at_.offset;
    std::size_t space = chunk.size - at_.offset;
    if (!std::align(alignment, bytes, start, space)) return nullptr;
    at_.offset = chunk.size - space + bytes;
    return start;
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
