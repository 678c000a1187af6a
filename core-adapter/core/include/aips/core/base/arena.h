// Memory that is dropped all at once.
#pragma once

#include <cstddef>
#include <memory>
#include <memory_resource>
#include <vector>

#include "aips/core/base/cache_line.h"

namespace aips {

/// Bump allocator: allocations are given back together, by rewind() or reset(); chunks are kept for
/// reuse, so that a warm arena takes no memory. Not for many threads at once. Objects in it are
/// dropped without their destructors.
class alignas(kCacheLine) Arena final : public std::pmr::memory_resource {
  public:
    /// A place to rewind to.
    struct Mark {
        std::size_t chunk = 0;
        std::size_t offset = 0;
    };
    /// Size of a chunk, unless one allocation needs a larger one.
    static constexpr std::size_t kChunkBytes = 16384;

    explicit Arena(std::size_t chunk_bytes = kChunkBytes) : chunk_bytes_(chunk_bytes) {}

    Mark mark() const { return at_; }
    /// Drops all that was allocated since mark() returned `mark`.
    void rewind(Mark mark) { at_ = mark; }
    /// Drops everything.
    void reset() { at_ = {}; }
    /// Memory held, used or not.
    std::size_t bytes_reserved() const;

  private:
    struct Chunk {
        std::unique_ptr<std::byte[]> memory;
        std::size_t size = 0;
    };

    void* do_allocate(std::size_t bytes, std::size_t alignment) override;
    void do_deallocate(void*, std::size_t, std::size_t) override {}
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
        return this == &other;
    }
    /// Room in the chunk in use, or null.
    void* bump(std::size_t bytes, std::size_t alignment);

    std::size_t chunk_bytes_;
    std::vector<Chunk> chunks_;
    Mark at_;
};

}  // namespace aips
