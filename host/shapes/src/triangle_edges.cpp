// The edges of a triangle mesh.
#include "triangle_edges.h"

#include <algorithm>
#include <tuple>

namespace lxs {

TriangleEdges::TriangleEdges(const std::vector<Index>& corners) : of(corners.size()) {
    struct Side {
        Index a, b, at;
    };
    std::vector<Side> sides;
    sides.reserve(corners.size());
    for (Index at = 0; at < corners.size(); ++at) {
        const Index from = corners[at], to = corners[at % 3 == 2 ? at - 2 : at + 1];
        sides.push_back({std::min(from, to), std::max(from, to), at});
    }
    std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
        return std::tie(x.a, x.b, x.at) < std::tie(y.a, y.b, y.at);
    });
    for (const Side& side : sides) {
        if (list.empty() || list.back().a != side.a || list.back().b != side.b)
            list.push_back({side.a, side.b});
        Edge& edge = list.back();
        const Index opposite = corners[side.at - side.at % 3 + (side.at + 2) % 3];
        if (edge.faces < 2) edge.opposite[static_cast<std::size_t>(edge.faces)] = opposite;
        ++edge.faces;
        of[side.at] = static_cast<Index>(list.size() - 1);
    }
}

}  // namespace lxs
