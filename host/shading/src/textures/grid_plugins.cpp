// Texture "densitygrid": values by cell, from a list or a volume file.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <stdexcept>

#include "formula_texture.h"
#include "lxs/images/image_library.h"
#include "space_mapping.h"
#include "texture_parameters.h"
#include "texture_plugins.h"
#include "wrap.h"

namespace lxs::shading {
namespace {

using Cell = std::array<std::int64_t, 3>;

/// What lies between cells, whose values stand at whole numbers: linear in each coordinate. `value`
/// of a cell; `p` below 2^24 or so.
template <class T, class Value>
T between_cells(const Vec3& p, Value&& value) {
    Cell first;
    Vec3 share;
    for (int axis = 0; axis < 3; ++axis) {
        const float below = std::floor(p[axis]);
        first[std::size_t(axis)] = static_cast<std::int64_t>(below);
        share[axis] = p[axis] - below;
    }
    T sum(0.0f);
    for (std::int64_t corner = 0; corner < 8; ++corner) {
        const std::int64_t x = corner & 1, y = (corner >> 1) & 1, z = corner >> 2;
        const float weight =
            (x ? share.x : 1 - share.x) * (y ? share.y : 1 - share.y) * (z ? share.z : 1 - share.z);
        sum += value(Cell{first[0] + x, first[1] + y, first[2] + z}) * weight;
    }
    return sum;
}

/// A list that fills the unit cube.
template <class T>
struct ListedGrid {
    Cell size{};
    std::vector<T> values;
    Wrap wrap = Wrap::Repeat;
    bool cut = false;  ///< nothing outside of the unit cube

    T cell(Cell index) const {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t n = size[axis];
            if (index[axis] >= 0 && index[axis] < n) continue;
            if (wrap == Wrap::Black || wrap == Wrap::White) return outside();
            index[axis] = wrap == Wrap::Clamp ? std::clamp<std::int64_t>(index[axis], 0, n - 1)
                                              : ((index[axis] % n) + n) % n;
        }
        return values[static_cast<std::size_t>((index[2] * size[1] + index[1]) * size[0] +
                                               index[0])];
    }
    Matrix cells() const {
        Matrix sides;
        sides.setScale(
            Imath::V3d(1.0 / double(size[0]), 1.0 / double(size[1]), 1.0 / double(size[2])));
        return sides;
    }
    T outside() const { return T(wrap == Wrap::White ? 1.0f : 0.0f); }

    T at(const Vec3& p) const {
        constexpr float kFarthest = 1e6f;  // in cells: no index overflows
        Vec3 place;
        for (int axis = 0; axis < 3; ++axis) {
            if (cut && !(p[axis] >= 0 && p[axis] <= 1)) return T(0.0f);
            place[axis] = p[axis] * static_cast<float>(size[std::size_t(axis)]) - 0.5f;
            if (!(std::abs(place[axis]) < kFarthest)) return outside();
        }
        return between_cells<T>(place, [&](const Cell& index) { return cell(index); });
    }
};

/// A grid of a volume file; nothing lies around it.
template <class T>
struct FiledGrid {
    VoxelGrid grid;
    Imath::M44f to_voxels;

    const Matrix& cells() const { return grid.to_grid_space; }
    T voxel(const Cell& index) const {
        const float* const found = grid.at(index);
        if (found == nullptr) return T(0.0f);
        if constexpr (std::is_same_v<T, float>) {
            return grid.channels == 1 ? found[0] : (found[0] + found[1] + found[2]) / 3;
        } else {
            return grid.channels == 1 ? T(found[0]) : T(found[0], found[1], found[2]);
        }
    }

    T at(const Vec3& p) const {
        const Vec3 place = p * to_voxels;
        for (int axis = 0; axis < 3; ++axis) {
            const auto low = static_cast<float>(grid.first[std::size_t(axis)]);
            const auto side =
                static_cast<float>(grid.bricks[std::size_t(axis)] * VoxelGrid::kBrick);
            if (!(place[axis] > low - 1 && place[axis] < low + side)) return T(0.0f);
        }
        return between_cells<T>(place, [&](const Cell& index) { return voxel(index); });
    }
};

template <class T>
FiledGrid<T> filed(const ParameterReader& reader, const AssetContext& assets) {
    const std::string path =
        assets.resolve(reader.string("filename", ""), reader.where("filename"));
    FiledGrid<T> read;
    try {
        read.grid = image_library().read_grid(path, reader.string("gridname", "density"));
    } catch (const std::bad_alloc&) {
        throw EndOfReading(reader.where("filename"),
                           fmt::format("not enough memory for the grid in \"{}\"", path));
    } catch (const std::runtime_error& error) {
        reader.fail("filename", fmt::format("cannot read grid \"{}\": {}", path, error.what()));
    }
    if (read.grid.refused > 0) {
        reader.diagnostics().warning(
            reader.where("filename"),
            fmt::format("grid \"{}\" has {} values that are not finite or negative; 0 is used",
                        path, read.grid.refused));
    }
    try {
        read.to_voxels = Imath::M44f(read.grid.to_grid_space.inverse(true));
    } catch (const std::exception&) {
        reader.fail("filename", fmt::format("the grid in \"{}\" is flat", path));
    }
    return read;
}

template <class T>
ListedGrid<T> listed(const ParameterReader& reader) {
    ListedGrid<T> grid;
    grid.size = {reader.integer("nx", 1), reader.integer("ny", 1), reader.integer("nz", 1)};
    const auto numbers = reader.numbers("density");
    constexpr std::size_t kChannels = std::is_same_v<T, float> ? 1 : 3;
    if (static_cast<double>(numbers.size()) !=
        double(kChannels) * double(grid.size[0]) * double(grid.size[1]) * double(grid.size[2])) {
        reader.fail("density",
                    fmt::format("densitygrid: \"density\" needs nx * ny * nz values, but has {}",
                                numbers.size() / kChannels));
    }
    if constexpr (kChannels == 1) {
        grid.values.assign(numbers.begin(), numbers.end());
    } else {
        for (std::size_t i = 0; i < numbers.size(); i += 3)
            grid.values.emplace_back(float(numbers[i]), float(numbers[i + 1]),
                                     float(numbers[i + 2]));
    }
    grid.wrap = read_wrap(reader);
    grid.cut = reader.boolean("cut", false);
    return grid;
}

template <class Grid, class T>
std::shared_ptr<const Texture<T>> placed(Grid grid, const ParameterReader& reader,
                                         const Matrix& to_world) {
    const SpaceMapping mapping(reader, to_world);
    const float cell_size = mapping.shortest_in_world(grid.cells());
    return formula_texture<T>([grid = std::move(grid), mapping](
                                  const TexturePoint& point) { return grid.at(mapping(point)); },
                              false, cell_size);
}

ParameterDeclaration cells(std::string_view name, std::string_view doc) {
    return {name, ParameterType::Integer, "1", doc, 1, 65536};
}

template <class T>
typename TextureKind<T>::Factory densitygrid_plugin() {
    ParameterDeclaration density{"density", TextureKind<T>::kValue, "",
                                 "nx * ny * nz values, x running fastest, in the unit cube of the "
                                 "texture's space"};
    density.array = true;
    return {declarations(
                {{density,
                  cells("nx", "cells along x"),
                  cells("ny", "cells along y"),
                  cells("nz", "cells along z"),
                  wrap_parameter("values outside of the unit cube"),
                  {"cut", ParameterType::Bool, "false",
                   "0 outside of the unit cube, whatever wrap says"},
                  {"filename", ParameterType::String, "",
                   "OpenVDB or NanoVDB file in place of a list; its own space is the texture's"},
                  {"gridname", ParameterType::String, "density", "grid of the file"}},
                 space_mapping_parameters()}),
            [](const ParameterReader& reader, const AssetContext& assets, const Matrix& to_world) {
                if (reader.given("filename"))
                    return placed<FiledGrid<T>, T>(filed<T>(reader, assets), reader, to_world);
                return placed<ListedGrid<T>, T>(listed<T>(reader), reader, to_world);
            }};
}

}  // namespace

void register_grids(Registry& registry) {
    registry.float_textures["densitygrid"] = densitygrid_plugin<float>();
    registry.color_textures["densitygrid"] = densitygrid_plugin<Rgb>();
}

}  // namespace lxs::shading
