// OpenVDB files, which OpenImageIO reads as images of tiles.
#include <OpenImageIO/imageio.h>

#include <memory>
#include <stdexcept>

#include "checked_input.h"
#include "volume_file.h"

namespace lxs {
namespace {

constexpr const char* kMatrix = "openvdb:indextoworld";

/// Values of one brick as the file has them.
template <class Stored>
GridBricks::Read brick_reader(OIIO::ImageInput& file, int grid) {
    return [&file, grid, stored = std::vector<Stored>()](const VoxelGrid::Voxel& at,
                                                         std::span<float> values) mutable {
        stored.assign(values.size(), Stored(0));
        if (!file.read_native_tile(grid, 0, int(at[0]), int(at[1]), int(at[2]), stored.data()))
            throw std::runtime_error(first_line(file.geterror()));
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = static_cast<float>(stored[i]);
        return true;
    };
}

void read_bricks(OIIO::ImageInput& file, int index, const OIIO::ImageSpec& spec, VoxelGrid& grid) {
    if (spec.nchannels != 1 && spec.nchannels != 3)
        throw std::runtime_error("its grid is one of neither numbers nor colours");
    if (spec.tile_width != VoxelGrid::kBrick || spec.tile_height != VoxelGrid::kBrick ||
        spec.tile_depth != VoxelGrid::kBrick)
        throw std::runtime_error("its grid has leaves of another size than 8");
    grid.channels = spec.nchannels;
    if (!spec.getattribute(kMatrix,
                           OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE, OIIO::TypeDesc::MATRIX44),
                           grid.to_grid_space.getValue()))
        throw std::runtime_error("its grid has no linear transform");
    // The full window is the box of active voxels. The data window, tiles around it, misses some
    // where numbers of voxels are negative.
    const VoxelGrid::Voxel low{spec.full_x, spec.full_y, spec.full_z};
    const VoxelGrid::Voxel high{low[0] + spec.full_width - 1, low[1] + spec.full_height - 1,
                                low[2] + spec.full_depth - 1};
    GridBricks bricks(grid, low, high);
    if (spec.format == OIIO::TypeDesc::DOUBLE) {
        bricks.fill(brick_reader<double>(file, index));
    } else if (spec.format == OIIO::TypeDesc::FLOAT) {
        bricks.fill(brick_reader<float>(file, index));
    } else {
        throw std::runtime_error("its grid is not one of real numbers");
    }
}

}  // namespace

VoxelGrid read_openvdb(const std::string& path, const std::string& name) {
    return with_reasons([&] {
        const auto file = OIIO::ImageInput::create("openvdb");
        if (!file) throw std::runtime_error("the installed OpenImageIO reads no OpenVDB files");
        OIIO::ImageSpec ignored;
        if (!file->open(path, ignored)) throw std::runtime_error(first_line(file->geterror()));
        std::vector<std::string> known;
        for (int index = 0; file->seek_subimage(index, 0); ++index) {
            const OIIO::ImageSpec spec = file->spec(index, 0);
            known.push_back(spec.get_string_attribute("oiio:subimagename"));
            if (known.back() != name) continue;
            VoxelGrid grid;
            read_bricks(*file, index, spec, grid);
            return grid;
        }
        fail_without_grid(name, known);
    });
}

}  // namespace lxs
