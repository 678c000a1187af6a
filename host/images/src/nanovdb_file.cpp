// NanoVDB files.
#include <iostream>  // that NanoVDB's headers miss

#define NANOVDB_USE_ZIP 1
#define NANOVDB_USE_BLOSC 1
#include <nanovdb/util/GridValidator.h>
#include <nanovdb/util/IO.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "checked_input.h"
#include "volume_file.h"

namespace lxs {
namespace {

using Handle = nanovdb::GridHandle<nanovdb::HostBuffer>;

float channel(float value, int) {
    return value;
}
float channel(const nanovdb::Vec3f& value, int index) {
    return value[index];
}

template <class Value>
void read_bricks(const Handle& handle, VoxelGrid& grid) {
    const nanovdb::NanoGrid<Value>* const found = handle.grid<Value>();
#ifndef __clang_analyzer__  // it sees a leak in NanoVDB's own header
    if (!nanovdb::isValid(*found, false)) throw std::runtime_error("its grid is damaged");
#endif
    const nanovdb::Map& map = found->map();
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            grid.to_grid_space[i][j] = map.mMatD[3 * j + i];
        grid.to_grid_space[3][i] = map.mVecD[i];
    }
    const auto box = found->indexBBox();
    const VoxelGrid::Voxel low{box.min()[0], box.min()[1], box.min()[2]};
    const VoxelGrid::Voxel high{box.max()[0], box.max()[1], box.max()[2]};
    auto tree = found->getAccessor();
    GridBricks(grid, low, high).fill([&](const VoxelGrid::Voxel& at, std::span<float> values) {
        const nanovdb::Coord first{int(at[0]), int(at[1]), int(at[2])};
        float* next = values.data();
        for (int z = 0; z < VoxelGrid::kBrick; ++z)
            for (int y = 0; y < VoxelGrid::kBrick; ++y)
                for (int x = 0; x < VoxelGrid::kBrick; ++x)
                    for (int c = 0; c < grid.channels; ++c)
                        *next++ = channel(tree.getValue(first.offsetBy(x, y, z)), c);
        return true;
    });
}

/// Throws unless the file has the grid, of no more bytes than it can hold.
void check_named(const std::string& path, const std::string& name) {
    constexpr std::uint64_t kMostOfAByte = 1032;  // that zlib makes (zlib.net, "Maximum ...")
    std::vector<std::string> known;
    for (const nanovdb::io::GridMetaData& grid : nanovdb::io::readGridMetaData(path)) {
        known.push_back(grid.gridName);
        if (grid.gridName == name &&
            grid.gridSize / kMostOfAByte > std::filesystem::file_size(path))
            throw std::runtime_error("its grid claims more than the file can hold");
    }
    if (std::ranges::find(known, name) == known.end()) fail_without_grid(name, known);
}

}  // namespace

VoxelGrid read_nanovdb(const std::string& path, const std::string& name) {
    return with_reasons([&] {
        check_named(path, name);
        const Handle handle = nanovdb::io::readGrid(path, name);
        VoxelGrid grid;
        switch (handle.gridMetaData()->gridType()) {
            case nanovdb::GridType::Float:
                read_bricks<float>(handle, grid);
                break;
            case nanovdb::GridType::Vec3f:
                grid.channels = 3;
                read_bricks<nanovdb::Vec3f>(handle, grid);
                break;
            default:
                throw std::runtime_error("its grid is not one of floats or colours");
        }
        return grid;
    });
}

}  // namespace lxs
