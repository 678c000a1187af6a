// A grid of a volume file (OpenVDB or NanoVDB): values by voxel, in bricks that are there only
// where the file holds more than nothing.
#pragma once

#include <Imath/ImathMatrix.h>

#include <array>
#include <cstdint>
#include <vector>

namespace lxs {

struct VoxelGrid {
    static constexpr int kBrick = 8;  ///< voxels along a brick's side: those of both files' leaves
    static constexpr int kBrickVoxels = kBrick * kBrick * kBrick;

    using Voxel = std::array<std::int64_t, 3>;

    int channels = 1;                  ///< 1 or 3
    Voxel first{};                     ///< of the first brick, a multiple of kBrick
    Voxel bricks{};                    ///< along each axis
    Imath::M44d to_grid_space;         ///< from voxels, whose values stand at whole numbers
    std::vector<std::int32_t> places;  ///< [z][y][x] of bricks: its place in `values`; -1: nothing
    std::vector<float> values;         ///< [place][z][y][x][channel], finite and >= 0
    std::uint64_t refused = 0;         ///< values of the file that were not, in whose place 0 is

    /// The channels of a voxel; null where there is nothing.
    const float* at(const Voxel& voxel) const {
        std::array<std::int64_t, 3> brick, within;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t place = voxel[axis] - first[axis];
            if (place < 0 || place >= bricks[axis] * kBrick) return nullptr;
            brick[axis] = place / kBrick;
            within[axis] = place % kBrick;
        }
        const std::int32_t place = places[static_cast<std::size_t>(
            (brick[2] * bricks[1] + brick[1]) * bricks[0] + brick[0])];
        if (place < 0) return nullptr;
        const std::int64_t inside = (within[2] * kBrick + within[1]) * kBrick + within[0];
        return values.data() +
               (std::size_t(place) * kBrickVoxels + std::size_t(inside)) * std::size_t(channels);
    }
};

}  // namespace lxs
