// Placement of three-dimensional textures.
#include "space_mapping.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "texture_space.h"

namespace lxs::shading {
namespace {

constexpr std::array<std::string_view, 5> kCoordinates{"global", "local", "globalnormal",
                                                       "localnormal", "uv"};

/// Scaling, then turns about x, y, z, then the move.
Matrix own_placement(const ParameterReader& reader) {
    constexpr double kRadians = std::numbers::pi / 180;
    const Imath::V3d angles(reader.vector("rotate", Vec3(0.0f)));
    Matrix placement;
    placement.setScale(Imath::V3d(reader.vector("scale", Vec3(1.0f))));
    for (int axis = 0; axis < 3; ++axis) {
        Imath::V3d direction(0.0);
        direction[axis] = 1;
        Matrix turn;
        turn.setAxisAngle(direction, angles[axis] * kRadians);
        placement *= turn;
    }
    Matrix move;
    move.setTranslation(Imath::V3d(reader.vector("translate", Vec3(0.0f))));
    return placement * move;
}

/// Unit, or zero.
Vec3 turned(const Vec3& normal, const Matrix& by) {
    Vec3 turned;
    by.multDirMatrix(normal, turned);
    return turned.normalized();
}

}  // namespace

Vec3 local_position(const TexturePoint& point) {
    Vec3 p = point.p;
    for (const Matrix* step : {point.world_to_object, point.object_to_shape})
        if (step) p = p * *step;
    return p;
}

/// Normals go by the transpose of the inverse of the matrix that positions go by.
Vec3 local_normal(const TexturePoint& point) {
    Vec3 n = point.n;
    for (const Matrix* step : {point.world_to_object, point.object_to_shape})
        if (step) n = turned(n, step->inverse().transposed());
    return n;
}

SpaceMapping::SpaceMapping(const ParameterReader& reader, const Matrix& to_world) {
    const Matrix placed = own_placement(reader) * to_world;
    to_texture_ = inverse_or_fail(reader, "scale", placed);
    normal_to_texture_ = placed.transposed();
    const std::string name = reader.string("coordinates", "global");
    uv_ = name == "uv";
    local_ = name.starts_with("local");
    normal_ = name.ends_with("normal");
}

Vec3 SpaceMapping::operator()(const TexturePoint& point) const {
    if (uv_) return Vec3(point.uv.x, point.uv.y, 0) * to_texture_;
    if (normal_) return turned(local_ ? local_normal(point) : point.n, normal_to_texture_);
    return (local_ ? local_position(point) : point.p) * to_texture_;
}

float SpaceMapping::shortest_in_world(const Matrix& steps) const {
    if (uv_ || normal_ || local_) return 0;
    const Matrix to_world = steps * Matrix(to_texture_).inverse();
    double shortest = std::numeric_limits<double>::max();
    for (int axis = 0; axis < 3; ++axis) {
        Imath::V3d step(0.0), in_world;
        step[axis] = 1;
        to_world.multDirMatrix(step, in_world);
        shortest = std::min(shortest, in_world.length());
    }
    return static_cast<float>(shortest);
}

std::vector<ParameterDeclaration> space_mapping_parameters() {
    ParameterDeclaration coordinates{"coordinates", ParameterType::String, "global",
                                     "what is looked up: the position or the normal, in world "
                                     "(global) or shape (local) space, or (u, v, 0)"};
    coordinates.choices = kCoordinates;
    return {coordinates,
            {"translate", ParameterType::Vector, "0 0 0", "moves the texture"},
            {"rotate", ParameterType::Vector, "0 0 0",
             "turns the texture about x, then y, then z, in degrees"},
            {"scale", ParameterType::Vector, "1 1 1", "enlarges the texture"}};
}

}  // namespace lxs::shading
