// The edges of a triangle mesh, each with the triangles that share it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace lxs {

/// The edges of a list of triangles: edge k of triangle t, from its corner k to the next, has
/// number `of[3 t + k]`.
struct TriangleEdges {
    using Index = std::uint32_t;
    static constexpr Index kNone = ~Index{0};
    struct Edge {
        Index a, b;                                   ///< corners, a < b
        std::array<Index, 2> opposite{kNone, kNone};  ///< third corners of its triangles
        int faces = 0;
        bool inner() const { return faces == 2; }
    };
    std::vector<Edge> list;
    std::vector<Index> of;

    explicit TriangleEdges(const std::vector<Index>& corners);
};

}  // namespace lxs
