// Grids of volume files: what their readers have in common.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lxs/images/voxel_grid.h"

namespace lxs {

/// Fills a grid brick by brick.
class GridBricks {
  public:
    /// Voxels from `low` to `high`, both included. Throws std::runtime_error where a box of that
    /// size is not believed.
    GridBricks(VoxelGrid& grid, const VoxelGrid::Voxel& low, const VoxelGrid::Voxel& high);

    /// Asks for the values of each brick, whose first voxel is named: [z][y][x][channel], or false
    /// where there are none.
    using Read = std::function<bool(const VoxelGrid::Voxel& first, std::span<float> values)>;
    void fill(const Read& read);

  private:
    VoxelGrid& grid_;
};

/// Throws: the file has no grid of that name, but these.
[[noreturn]] void fail_without_grid(const std::string& name, const std::vector<std::string>& known);

VoxelGrid read_openvdb(const std::string& path, const std::string& name);
VoxelGrid read_nanovdb(const std::string& path, const std::string& name);

/// By the file's first bytes.
VoxelGrid read_volume_file(const std::string& path, const std::string& name);

}  // namespace lxs
