// Protects the bump allocator: alignment, rewinding, reuse of chunks.
#include "aips/core/base/arena.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <memory_resource>
#include <utility>
#include <vector>

namespace aips::arena_test {
namespace {

TEST(Arena, AlignsAndKeepsAllocationsApart) {
    Arena arena(256);
    std::vector<std::pair<char*, std::size_t>> blocks;
    for (std::size_t i = 1; i < 200; ++i) {
        const std::size_t alignment = std::size_t{1} << (i % 8);
        auto* p = static_cast<char*>(arena.allocate(i, alignment));
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(p) % alignment, 0u);
        std::memset(p, static_cast<int>(i), i);
        blocks.emplace_back(p, i);
    }
    for (const auto& [p, size] : blocks) {
        for (std::size_t k = 0; k < size; ++k) {
            ASSERT_EQ(static_cast<unsigned char>(p[k]), static_cast<unsigned char>(size));
        }
    }
}

TEST(Arena, RewindGivesTheSameMemoryAgain) {
    Arena arena;
    (void)arena.allocate(100, 8);
    const Arena::Mark mark = arena.mark();
    void* first = arena.allocate(64, 16);
    arena.rewind(mark);
    EXPECT_EQ(arena.allocate(64, 16), first);
}

TEST(Arena, RewindAcrossChunks) {
    Arena arena(128);
    const Arena::Mark mark = arena.mark();
    void* first = arena.allocate(100, 1);
    (void)arena.allocate(100, 1);
    (void)arena.allocate(1000, 1);
    arena.rewind(mark);
    EXPECT_EQ(arena.allocate(100, 1), first);
}

TEST(Arena, WarmArenaTakesNoMemory) {
    Arena arena(512);
    const auto fill = [&] {
        for (int i = 0; i < 100; ++i)
            (void)arena.allocate(48, 16);
        (void)arena.allocate(5000, 64);
        for (int i = 0; i < 10; ++i)
            (void)arena.allocate(48, 16);
    };
    EXPECT_EQ(arena.bytes_reserved(), 0u);
    fill();
    const std::size_t reserved = arena.bytes_reserved();
    for (int i = 0; i < 50; ++i) {
        arena.reset();
        fill();
    }
    EXPECT_EQ(arena.bytes_reserved(), reserved);
}

TEST(Arena, ServesStandardContainersAndMoves) {
    std::vector<Arena> arenas(3);
    std::pmr::vector<int> values(&arenas[1]);
    for (int i = 0; i < 1000; ++i)
        values.push_back(i);
    EXPECT_EQ(values[999], 999);
    Arena moved;
    (void)moved.allocate(10, 1);
    const Arena taken = std::move(moved);
    EXPECT_EQ(taken.bytes_reserved(), Arena::kChunkBytes);
}

}  // namespace
}  // namespace aips::arena_test
