// Loop subdivision with limit positions and normals.
#include "subdivision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "triangle_edges.h"

namespace lxs {
namespace {

using Imath::V3d;
using Index = TriangleEdges::Index;

/// Weight of each of `n` neighbours in a vertex's new position (Warren 1995).
double neighbour_weight(std::size_t n) {
    return n == 3 ? 3.0 / 16 : 3.0 / (8 * static_cast<double>(n));
}

/// Each triangle's four parts, given the number of its first edge's new vertex.
std::vector<Index> split(const std::vector<Index>& corners, const TriangleEdges& edges,
                         Index first_new) {
    std::vector<Index> result;
    result.reserve(4 * corners.size());
    for (std::size_t t = 0; t < corners.size(); t += 3) {
        const Index a = corners[t], b = corners[t + 1], c = corners[t + 2];
        const Index ab = first_new + edges.of[t], bc = first_new + edges.of[t + 1];
        const Index ca = first_new + edges.of[t + 2];
        result.insert(result.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
    }
    return result;
}

/// Sums over each point's neighbours, on the boundary over those along it.
struct Rings {
    std::vector<V3d> sum;
    std::vector<Index> count;
    std::vector<bool> on_boundary;

    Rings(const std::vector<V3d>& points, const TriangleEdges& edges)
        : sum(points.size(), V3d(0.0)), count(points.size()), on_boundary(points.size()) {
        for (const TriangleEdges::Edge& edge : edges.list) {
            if (!edge.inner()) on_boundary[edge.a] = on_boundary[edge.b] = true;
        }
        for (const TriangleEdges::Edge& edge : edges.list) {
            for (const auto& [from, to] : {std::pair(edge.a, edge.b), std::pair(edge.b, edge.a)}) {
                if (on_boundary[from] && edge.inner()) continue;
                sum[from] += points[to];
                ++count[from];
            }
        }
    }
};

/// The share `boundary` of each of two boundary neighbours, or `inner(n)` of each of n others.
template <class Weight>
V3d moved_vertex(const V3d& p, const Rings& rings, std::size_t i, double boundary, bool sharp,
                 const Weight& inner) {
    const double n = rings.count[i];
    if (rings.on_boundary[i]) {
        if (sharp || rings.count[i] != 2) return p;  // more than one boundary meets: a corner
        return p * (1 - 2 * boundary) + rings.sum[i] * boundary;
    }
    if (n == 0) return p;
    const double w = inner(rings.count[i]);
    return p * (1 - n * w) + rings.sum[i] * w;
}

std::vector<V3d> refined(const std::vector<V3d>& points, const TriangleEdges& edges,
                         const SubdivisionRules& rules) {
    std::vector<V3d> result = points;
    if (rules.smooth) {
        const Rings rings(points, edges);
        for (std::size_t i = 0; i < points.size(); ++i) {
            result[i] =
                moved_vertex(points[i], rings, i, 1.0 / 8, rules.sharp_boundary, neighbour_weight);
        }
    }
    result.reserve(points.size() + edges.list.size());
    for (const TriangleEdges::Edge& edge : edges.list) {
        const V3d ends = points[edge.a] + points[edge.b];
        if (rules.smooth && edge.inner()) {
            const V3d sides = points[edge.opposite[0]] + points[edge.opposite[1]];
            result.push_back(ends * (3.0 / 8) + sides * (1.0 / 8));
        } else {
            result.push_back(ends * 0.5);
        }
    }
    return result;
}

/// Where points go in the limit of ever more levels.
std::vector<V3d> limit_positions(const std::vector<V3d>& points, const TriangleEdges& edges,
                                 const SubdivisionRules& rules) {
    const Rings rings(points, edges);
    std::vector<V3d> result;
    result.reserve(points.size());
    const auto weight = [](std::size_t n) {
        return 1 / (static_cast<double>(n) + 3 / (8 * neighbour_weight(n)));
    };
    for (std::size_t i = 0; i < points.size(); ++i)
        result.push_back(moved_vertex(points[i], rings, i, 1.0 / 6, rules.sharp_boundary, weight));
    return result;
}

/// A vertex's neighbours in order around it: `next[i]` and `previous` by the triangles that hold
/// it.
std::vector<Index> ordered_ring(Index vertex, const Index* triangles, std::size_t count,
                                const std::vector<Index>& corners, bool& closed) {
    std::vector<std::pair<Index, Index>> steps;  // from a neighbour to the next
    for (std::size_t i = 0; i < count; ++i) {
        const Index* t = &corners[3 * std::size_t{triangles[i]}];
        const std::size_t k = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
        steps.emplace_back(t[(k + 1) % 3], t[(k + 2) % 3]);
    }
    // Sorted, as a vertex may be the middle of a fan of millions.
    std::vector<Index> reached;
    std::vector<std::pair<Index, std::size_t>> from;  // where a step begins, and its number
    for (std::size_t i = 0; i < steps.size(); ++i) {
        reached.push_back(steps[i].second);
        from.emplace_back(steps[i].first, i);
    }
    std::sort(reached.begin(), reached.end());
    std::sort(from.begin(), from.end());
    // An open ring begins where no triangle leads to.
    Index at = steps.front().first;
    for (const auto& step : steps) {
        if (!std::binary_search(reached.begin(), reached.end(), step.first)) at = step.first;
    }
    std::vector<Index> ring{at};
    closed = false;
    while (ring.size() <= steps.size()) {
        const auto step = std::lower_bound(from.begin(), from.end(), std::pair(at, std::size_t{0}));
        if (step == from.end() || step->first != at) break;
        at = steps[step->second].second;
        if (at == ring.front()) {
            closed = true;
            break;
        }
        ring.push_back(at);
    }
    return ring;
}

/// Normal of the limit surface from the ring of control points (not unit).
V3d limit_normal(const V3d& center, const std::vector<Index>& ring, bool closed,
                 const std::vector<V3d>& points) {
    const std::size_t n = ring.size();
    V3d s(0.0), t(0.0);
    if (closed) {
        for (std::size_t k = 0; k < n; ++k) {
            const double angle =
                2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
            s += points[ring[k]] * std::cos(angle);
            t += points[ring[k]] * std::sin(angle);
        }
        return s.cross(t);
    }
    s = points[ring[n - 1]] - points[ring[0]];  // along the boundary
    if (n == 2) {
        t = points[ring[0]] + points[ring[1]] - center * 2;
    } else if (n == 3) {
        t = points[ring[1]] - center;
    } else if (n == 4) {
        t = -points[ring[0]] + points[ring[1]] * 2 + points[ring[2]] * 2 - points[ring[3]] -
            center * 2;
    } else {
        const double theta = std::numbers::pi / static_cast<double>(n - 1);
        t = (points[ring[0]] + points[ring[n - 1]]) * std::sin(theta);
        for (std::size_t k = 1; k + 1 < n; ++k) {
            t += points[ring[k]] *
                 ((2 * std::cos(theta) - 2) * std::sin(theta * static_cast<double>(k)));
        }
        t = -t;
    }
    return t.cross(s);
}

std::vector<V3d> limit_normals(const std::vector<V3d>& points, const std::vector<Index>& corners) {
    // Triangles by corner, counted, then listed.
    std::vector<Index> begin(points.size() + 1, 0), triangles(corners.size());
    for (const Index p : corners)
        ++begin[p + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index> fill(begin.begin(), begin.end() - 1);
    for (Index at = 0; at < corners.size(); ++at)
        triangles[fill[corners[at]]++] = at / 3;
    std::vector<V3d> normals(points.size(), V3d(0.0));
    for (Index p = 0; p < points.size(); ++p) {
        const std::size_t count = begin[p + 1] - begin[p];
        if (count == 0) continue;
        bool closed = false;
        const auto ring = ordered_ring(p, &triangles[begin[p]], count, corners, closed);
        normals[p] = limit_normal(points[p], ring, closed, points);
    }
    return normals;
}

/// `values` with the middles of edges behind them.
template <class T>
void append_middles(std::vector<T>& values, const TriangleEdges& edges) {
    if (values.empty()) return;
    values.reserve(values.size() + edges.list.size());
    for (const TriangleEdges::Edge& edge : edges.list)
        values.push_back((values[edge.a] + values[edge.b]) * 0.5f);
}

}  // namespace

std::vector<Index> places_of(const std::vector<Vec3>& positions) {
    std::vector<Index> order(positions.size()), place(positions.size());
    std::iota(order.begin(), order.end(), Index{0});
    const auto key = [&](Index i) {
        const Vec3& p = positions[i];
        return std::tie(p.x, p.y, p.z);
    };
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && positions[order[i]] == positions[order[i - 1]];
        place[order[i]] = same ? place[order[i - 1]] : order[i];
    }
    return place;
}

namespace {

/// Corners of the triangles with three places, and these in `corners`. Others (the poles of spheres
/// made of quads) would pass for edges of the surface.
std::vector<Index> without_collapsed(const std::vector<Index>& indices,
                                     const std::vector<Index>& place, std::vector<Index>& corners) {
    std::vector<Index> kept;
    for (std::size_t at = 0; at + 2 < indices.size(); at += 3) {
        const Index a = place[indices[at]], b = place[indices[at + 1]], c = place[indices[at + 2]];
        if (a == b || b == c || c == a) continue;
        kept.insert(kept.end(), {indices[at], indices[at + 1], indices[at + 2]});
        corners.insert(corners.end(), {a, b, c});
    }
    return kept;
}

}  // namespace

// Two meshes of the same triangles are split in step: `corners` name places, which move; the
// result's indices name vertices, which carry the rest.
TriangleMesh subdivide(const TriangleMesh& mesh, int levels, const SubdivisionRules& rules) {
    TriangleMesh result = mesh;
    if (rules.smooth) result.normals.clear();
    std::vector<Index> place(mesh.positions.size());
    std::iota(place.begin(), place.end(), Index{0});
    if (rules.merge) place = places_of(mesh.positions);
    std::vector<V3d> points(mesh.positions.begin(), mesh.positions.end());
    std::vector<Index> corners;
    result.indices = without_collapsed(mesh.indices, place, corners);
    for (int level = 0; level < levels; ++level) {
        const TriangleEdges edges(corners), seams(result.indices);
        const auto first_point = static_cast<Index>(points.size());
        points = refined(points, edges, rules);
        place.resize(place.size() + seams.list.size());
        const std::size_t first_vertex = place.size() - seams.list.size();
        for (std::size_t at = 0; at < corners.size(); ++at)
            place[first_vertex + seams.of[at]] = first_point + edges.of[at];
        append_middles(result.uvs, seams);
        append_middles(result.colors, seams);
        append_middles(result.alphas, seams);
        append_middles(result.normals, seams);
        result.indices = split(result.indices, seams, static_cast<Index>(first_vertex));
        corners = split(corners, edges, first_point);
    }
    std::vector<V3d> normals;
    if (rules.smooth) {
        normals = limit_normals(points, corners);
        points = limit_positions(points, TriangleEdges(corners), rules);
        result.normals.resize(place.size());
    }
    result.positions.resize(place.size());
    for (std::size_t i = 0; i < place.size(); ++i) {
        result.positions[i] = Vec3(points[place[i]]);
        if (rules.smooth) result.normals[i] = Vec3(normals[place[i]].normalized());
    }
    return result;
}

}  // namespace lxs
