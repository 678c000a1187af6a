// Flights through the cells of a bounded field.
#pragma once

#include <algorithm>
#include <cmath>

#include "lxs/sdk/medium_field.h"

namespace lxs {

template <class Collide>
bool BoundedField::fly(const Vec3& origin, const Vec3& direction, float length,
                       HashedNumbers numbers, Collide&& collide) const {
    double depth = -std::log1p(-double(numbers.next()));
    for (GridWalk cells(grid_, origin, direction, double(length)); cells.inside(); cells.go_on()) {
        const float majorant_here = majorants_[cells.cell()];
        const double majorant = double(majorant_here);
        double at = cells.from();
        while (depth < majorant * (cells.to() - at)) {
            at += depth / majorant;
            const auto distance = float(at);
            const MediumCoefficients here = this->at(origin + direction * distance);
            // By rounding the place may be the next cell's, whose most is greater.
            const float most = std::max(majorant_here, max_component(here.extinction()));
            if (collide(distance, here, most)) return true;
            depth = -std::log1p(-double(numbers.next()));
        }
        depth -= majorant * (cells.to() - at);
    }
    return false;
}

}  // namespace lxs
