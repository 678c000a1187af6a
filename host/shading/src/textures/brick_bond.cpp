// Where bricks and mortar are, for seven bonds.
#include "brick_bond.h"

#include <algorithm>
#include <cmath>

namespace lxs::shading {
namespace {

float fraction(float x) {
    return x - std::floor(x);
}

/// Remainder in [0, period).
float modulo(float x, float period) {
    return x - period * std::floor(x / period);
}

/// Distance along x behind the last joint of a row in which `whole` bricks of length 1 and a half
/// one take turns.
float behind_joint_with_half(float x, float whole) {
    const float place = modulo(x, whole + 0.5f);
    return place < whole ? fraction(place) : place - whole;
}

/// Distance behind the last joint in a row of a wall; `x` and the result in lengths of bricks.
float behind_joint(BrickBond bond, float x, float row) {
    switch (bond) {
        case BrickBond::Flemish:
            return behind_joint_with_half(x, 1);
        case BrickBond::ChainLink:
            return behind_joint_with_half(x, 2);
        case BrickBond::English:
            return modulo(x, modulo(row, 2) == 0 ? 1.0f : 0.5f);
        default:
            return fraction(x);
    }
}

bool in_wall_brick(const BrickLayout& layout, const Vec3& p) {
    const float row = std::floor(p.z / layout.size.z);
    const float shift = layout.bond == BrickBond::Stacked ? 0.0f : row * layout.run;
    const float x = behind_joint(layout.bond, p.x / layout.size.x + shift, row) * layout.size.x;
    const float y = fraction(p.y / layout.size.y + 0.5f) * layout.size.y;
    const float z = p.z - row * layout.size.z;
    return std::min({x, y, z}) > layout.mortar;
}

/// Bricks on a chessboard of squares as long as a brick, lying along x and y in turn; in a square
/// there are `count` of them.
Vec2 behind_joints_of_basket(const Vec2& p, float length, float count) {
    const Vec2 square(std::floor(p.x / length), std::floor(p.y / length));
    const Vec2 within = p - square * length;
    const float breadth = length / count;
    const bool along_x = modulo(square.x + square.y, 2) == 0;
    return along_x ? Vec2(within.x, modulo(within.y, breadth))
                   : Vec2(modulo(within.x, breadth), within.y);
}

/// Bricks `count` cells long on a lattice of square cells; from row to row they step by a cell.
/// Along a row, `count` cells of one brick that lies along x are followed by as many that belong to
/// bricks along y.
Vec2 behind_joints_of_herringbone(const Vec2& p, float cell_size, float count) {
    const Vec2 cell(std::floor(p.x / cell_size), std::floor(p.y / cell_size));
    const Vec2 within = p - cell * cell_size;
    const float step = modulo(cell.x - cell.y, 2 * count);
    if (step < count) return {within.x + step * cell_size, within.y};
    return {within.x, within.y + (2 * count - 1 - step) * cell_size};
}

bool in_floor_brick(const BrickLayout& layout, const Vec3& p) {
    // Whole bricks have to fit: the depth is taken as the nearest fraction of the length.
    const float count = std::max(1.0f, std::round(layout.size.x / layout.size.y));
    const Vec2 behind =
        layout.bond == BrickBond::Basket
            ? behind_joints_of_basket({p.x, p.y}, layout.size.x, count)
            : behind_joints_of_herringbone({p.x, p.y}, layout.size.x / count, count);
    const float z = fraction(p.z / layout.size.z + 0.5f) * layout.size.z;
    return std::min({behind.x, behind.y, z}) > layout.mortar;
}

}  // namespace

bool in_brick(const BrickLayout& layout, const Vec3& p) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
    const Vec3 from_joint = p + Vec3(layout.mortar);  // a brick begins in the origin
    const bool floor = layout.bond == BrickBond::Herringbone || layout.bond == BrickBond::Basket;
    return floor ? in_floor_brick(layout, from_joint) : in_wall_brick(layout, from_joint);
}

}  // namespace lxs::shading
