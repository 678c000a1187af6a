// Where bricks and mortar are, for seven bonds.
#pragma once

#include <cstdint>

#include "lxs/sdk/types.h"

namespace lxs::shading {

enum class BrickBond : std::uint8_t {
    Stacked,      ///< joints in line
    Running,      ///< each row shifted against the one below
    Flemish,      ///< a brick and a half one in turn
    English,      ///< rows of bricks and rows of half ones
    ChainLink,    ///< two bricks and a half one in turn (monk bond)
    Herringbone,  ///< on the floor, x by y
    Basket        ///< on the floor, x by y
};

/// Walls lie along x and rise with z, the plane y = 0 in the middle of their bricks; floors lie in
/// x and y, the plane z = 0 in the middle. A brick stands with its joints in a box of `size`
/// (length, depth, height); the mortar is `mortar` wide, on the lower side of each coordinate.
struct BrickLayout {
    BrickBond bond = BrickBond::Running;
    Vec3 size{1.0f};
    float mortar = 0;
    float run = 0;  ///< shift from row to row in lengths of bricks; not for floors and stacks
};

/// Whether the point is in a brick and not in the mortar. False where it isn't finite.
bool in_brick(const BrickLayout& layout, const Vec3& p);

}  // namespace lxs::shading
