// Which format a volume file has, and how its voxels get into bricks.
#include "volume_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace lxs {
namespace {

/// Bricks of the box around a grid: a box of 3000 voxels a side, whose places take 256 MiB.
constexpr std::int64_t kMostBricks = std::int64_t{1} << 26;
/// Farthest voxel: single precision tells its neighbours apart.
constexpr std::int64_t kFarthestVoxel = std::int64_t{1} << 23;

std::int64_t floored(std::int64_t voxel) {
    const std::int64_t rest = voxel % VoxelGrid::kBrick;
    return voxel - (rest < 0 ? rest + VoxelGrid::kBrick : rest);
}

}  // namespace

GridBricks::GridBricks(VoxelGrid& grid, const VoxelGrid::Voxel& low, const VoxelGrid::Voxel& high)
    : grid_(grid) {
    std::int64_t bricks = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (low[axis] > high[axis]) throw std::runtime_error("the grid holds nothing");
        if (low[axis] < -kFarthestVoxel || high[axis] > kFarthestVoxel)
            throw std::runtime_error("voxels of the grid lie too far from its origin");
        grid_.first[axis] = floored(low[axis]);
        grid_.bricks[axis] = (high[axis] - grid_.first[axis]) / VoxelGrid::kBrick + 1;
        bricks *= grid_.bricks[axis];
    }
    if (bricks > kMostBricks) {
        throw std::runtime_error(fmt::format("its grid is {} x {} x {} voxels wide, too many",
                                             high[0] - low[0] + 1, high[1] - low[1] + 1,
                                             high[2] - low[2] + 1));
    }
    grid_.places.assign(static_cast<std::size_t>(bricks), -1);
}

void GridBricks::fill(const Read& read) {
    std::vector<float> brick(VoxelGrid::kBrickVoxels * std::size_t(grid_.channels));
    std::int32_t filled = 0;
    auto place = grid_.places.begin();
    VoxelGrid::Voxel at = grid_.first;
    for (std::int64_t z = 0; z < grid_.bricks[2]; ++z) {
        at[2] = grid_.first[2] + z * VoxelGrid::kBrick;
        for (std::int64_t y = 0; y < grid_.bricks[1]; ++y) {
            at[1] = grid_.first[1] + y * VoxelGrid::kBrick;
            for (std::int64_t x = 0; x < grid_.bricks[0]; ++x, ++place) {
                at[0] = grid_.first[0] + x * VoxelGrid::kBrick;
                if (!read(at, brick)) continue;
                for (float& value : brick) {
                    if (value >= 0 && std::isfinite(value)) continue;
                    value = 0;
                    ++grid_.refused;
                }
                if (std::ranges::all_of(brick, [](float value) { return value == 0; })) continue;
                *place = filled++;
                grid_.values.insert(grid_.values.end(), brick.begin(), brick.end());
            }
        }
    }
    grid_.values.shrink_to_fit();
}

void fail_without_grid(const std::string& name, const std::vector<std::string>& known) {
    throw std::runtime_error(known.empty() ? "it has no grid of numbers"
                                           : fmt::format("it has no grid \"{}\", but \"{}\"", name,
                                                         fmt::join(known, "\", \"")));
}

VoxelGrid read_volume_file(const std::string& path, const std::string& name) {
    std::array<char, 8> start{};
    std::ifstream(path, std::ios::binary).read(start.data(), start.size());
    // OpenVDB begins with the number "VDB " in eight bytes, NanoVDB with "NanoVDB" and a version.
    if (std::memcmp(start.data(), " BDV", 4) == 0) return read_openvdb(path, name);
    if (std::memcmp(start.data(), "NanoVDB", 7) == 0) return read_nanovdb(path, name);
    throw std::runtime_error("it is neither an OpenVDB nor a NanoVDB file");
}

}  // namespace lxs
