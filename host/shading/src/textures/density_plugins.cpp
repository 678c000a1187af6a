// Densities in space: "exponential" and "densitygrid".
#include <algorithm>
#include <array>
#include <cmath>

#include "formula_texture.h"
#include "space_mapping.h"
#include "texture_parameters.h"
#include "texture_plugins.h"
#include "wrap.h"

namespace lxs::shading {
namespace {

std::shared_ptr<const FloatTexture> create_exponential(const ParameterReader& reader,
                                                       const AssetContext&,
                                                       const Matrix& to_world) {
    const Vec3 origin = reader.vector("origin", Vec3(0.0f));
    const Vec3 up = reader.vector("updir", Vec3(0, 0, 1)).normalized();
    const auto decay = static_cast<float>(reader.number("decay", 1));
    return formula_texture<float>(
        [=, mapping = SpaceMapping(reader, to_world)](const TexturePoint& point) {
            return std::exp(-decay * ((mapping(point) - origin) ^ up));
        });
}

/// Values at the middles of the cells of a grid that fills the unit cube, linear in between.
struct DensityGrid {
    std::array<std::int64_t, 3> size;
    std::vector<float> values;
    Wrap wrap = Wrap::Repeat;

    float cell(std::array<std::int64_t, 3> index) const {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t n = size[axis];
            if (index[axis] >= 0 && index[axis] < n) continue;
            if (wrap == Wrap::Black) return 0;
            if (wrap == Wrap::White) return 1;
            index[axis] = wrap == Wrap::Clamp ? std::clamp<std::int64_t>(index[axis], 0, n - 1)
                                              : ((index[axis] % n) + n) % n;
        }
        return values[static_cast<std::size_t>((index[2] * size[1] + index[1]) * size[0] +
                                               index[0])];
    }

    float at(const Vec3& p) const {
        constexpr float kFarthest = 1e6f;  // in cells: no index overflows
        std::array<std::int64_t, 3> first{};
        Vec3 share;
        for (int axis = 0; axis < 3; ++axis) {
            const float place =
                p[axis] * static_cast<float>(size[static_cast<std::size_t>(axis)]) - 0.5f;
            if (!(std::abs(place) < kFarthest)) return wrap == Wrap::White ? 1.0f : 0.0f;
            const float below = std::floor(place);
            first[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(below);
            share[axis] = place - below;
        }
        float sum = 0;
        for (std::int64_t corner = 0; corner < 8; ++corner) {
            const std::int64_t x = corner & 1, y = (corner >> 1) & 1, z = corner >> 2;
            const float weight = (x ? share.x : 1 - share.x) * (y ? share.y : 1 - share.y) *
                                 (z ? share.z : 1 - share.z);
            sum += weight * cell({first[0] + x, first[1] + y, first[2] + z});
        }
        return sum;
    }
};

std::shared_ptr<const FloatTexture> create_densitygrid(const ParameterReader& reader,
                                                       const AssetContext&,
                                                       const Matrix& to_world) {
    DensityGrid grid;
    grid.size = {reader.integer("nx", 1), reader.integer("ny", 1), reader.integer("nz", 1)};
    const auto density = reader.numbers("density");
    if (static_cast<double>(density.size()) !=
        double(grid.size[0]) * double(grid.size[1]) * double(grid.size[2])) {
        reader.fail("density", "densitygrid: \"density\" needs nx * ny * nz values, but has " +
                                   std::to_string(density.size()));
    }
    grid.values.assign(density.begin(), density.end());
    grid.wrap = read_wrap(reader);
    return formula_texture<float>(
        [grid = std::move(grid), mapping = SpaceMapping(reader, to_world)](
            const TexturePoint& point) { return grid.at(mapping(point)); });
}

ParameterDeclaration cells(std::string_view name, std::string_view doc) {
    return {name, ParameterType::Integer, "1", doc, 1, 65536};
}

}  // namespace

void register_density_textures(Registry& registry) {
    registry.float_textures["exponential"] = {
        declarations({{{"origin", ParameterType::Point, "0 0 0", "where the density is 1"},
                       {"updir", ParameterType::Vector, "0 0 1", "direction of the fall-off"},
                       {"decay", ParameterType::Float, "1",
                        "fall-off per unit of length: the density is exp(-decay * height)"}},
                      space_mapping_parameters()}),
        &create_exponential};
    ParameterDeclaration density{"density", ParameterType::Float, "",
                                 "nx * ny * nz values, x running fastest, in the unit cube of the "
                                 "texture's space"};
    density.array = true;
    registry.float_textures["densitygrid"] = {
        declarations(
            {{density, cells("nx", "cells along x"), cells("ny", "cells along y"),
              cells("nz", "cells along z"), wrap_parameter("values outside of the unit cube")},
             space_mapping_parameters()}),
        &create_densitygrid};
}

}  // namespace lxs::shading
