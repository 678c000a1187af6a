// Normals of vertices from the triangles around them, on all threads.
//
// Each thread has a range of the vertices and adds up the triangles that touch it in the mesh's
// order, so that the sums are the same for any number of ranges. It passes over blocks of triangles
// whose vertices all lie elsewhere: most of them, as meshes name their vertices in some order.
#include <tbb/task_arena.h>

#include <algorithm>

#include "lxs/scene/on_all_threads.h"
#include "mesh_data.h"

namespace lxs {
namespace {

using Imath::V3d;

constexpr std::size_t kCornersAtOnce = 3 << 10;

/// From the least to the greatest vertex that a block of corners names.
struct VertexRange {
    std::size_t first, last;
};

std::vector<VertexRange> ranges_of_blocks(const std::vector<std::uint32_t>& indices) {
    std::vector<VertexRange> ranges((indices.size() + kCornersAtOnce - 1) / kCornersAtOnce);
    const auto at = [&](std::size_t block) {
        return indices.begin() +
               static_cast<std::ptrdiff_t>(std::min(block * kCornersAtOnce, indices.size()));
    };
    const auto measure = [&](std::size_t block) {
        const auto [least, most] = std::minmax_element(at(block), at(block + 1));
        ranges[block] = {*least, *most};
    };
    tbb::parallel_for(std::size_t{0}, ranges.size(), measure);
    return ranges;
}

/// Normals of the vertices of `own`.
void sum_normals(const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& indices,
                 const std::vector<VertexRange>& blocks, VertexRange own,
                 std::vector<Vec3>& normals) {
    const auto is_own = [&](std::size_t v) { return v >= own.first && v <= own.last; };
    std::vector<V3d> sums(own.last - own.first + 1, V3d(0.0));
    for (std::size_t block = 0; block < blocks.size(); ++block) {
        if (blocks[block].first > own.last || blocks[block].last < own.first) continue;
        const std::size_t end = std::min((block + 1) * kCornersAtOnce, indices.size());
        for (std::size_t i = block * kCornersAtOnce; i < end; i += 3) {
            const std::uint32_t* const corner = &indices[i];
            if (!is_own(corner[0]) && !is_own(corner[1]) && !is_own(corner[2])) continue;
            const V3d p(positions[corner[0]]);
            const V3d normal =
                (V3d(positions[corner[1]]) - p).cross(V3d(positions[corner[2]]) - p).normalized();
            for (int k = 0; k < 3; ++k) {
                if (is_own(corner[k])) sums[corner[k] - own.first] += normal;
            }
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const double length = sums[i].length();
        normals[own.first + i] = length > 0 ? Vec3(sums[i] / length) : Vec3(0, 0, 1);
    }
}

}  // namespace

std::vector<Vec3> smooth_normals(const std::vector<Vec3>& positions,
                                 const std::vector<std::uint32_t>& indices) {
    std::vector<Vec3> normals(positions.size());
    const std::vector<VertexRange> blocks = ranges_of_blocks(indices);
    const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    const std::size_t count = positions.size();
    const std::size_t parts = std::min(threads, (count + kElementsAtOnce - 1) / kElementsAtOnce);
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
        const VertexRange own{count * part / parts, count * (part + 1) / parts - 1};
        sum_normals(positions, indices, blocks, own, normals);
    });
    return normals;
}

}  // namespace lxs
