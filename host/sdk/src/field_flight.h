// Flights through the cells of a bounded field.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "lxs/sdk/medium_field.h"

namespace lxs {

/// Numbers in [0, 1), independent of each other: SplitMix64 (Steele et al. 2014).
class FlightNumbers {
  public:
    explicit FlightNumbers(std::uint64_t seed) : state_(seed) {}
    float next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return float((z ^ (z >> 31)) >> 40) * 0x1p-24f;
    }

  private:
    std::uint64_t state_;
};

/// Amanatides & Woo 1987.
class BoundedField::Cells {
  public:
    Cells(const BoundedField& field, const Vec3& origin, const Vec3& direction, double length)
        : field_(field) {
        double enter = 0, leave = length;
        for (int axis = 0; axis < 3; ++axis) {
            const double d = direction[axis], o = origin[axis];
            const double low = field.bounds_.min[axis], high = field.bounds_.max[axis];
            if (d == 0) {
                if (o < low || o > high) leave = -1;
                continue;
            }
            const double a = (low - o) / d, b = (high - o) / d;
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        from_ = enter;
        end_ = leave;
        if (!inside()) return;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int i = int(axis);
            const double d = direction[i], width = field.width_[i], low = field.bounds_.min[i];
            const double at = (origin[i] + d * enter - low) / width;
            cell_[axis] = std::clamp(int(at), 0, field.cells_[axis] - 1);
            step_[axis] = d < 0 ? -1 : 1;
            if (d == 0) continue;
            next_[axis] = (low + (cell_[axis] + (d > 0)) * width - origin[i]) / d;
            stride_[axis] = width / std::abs(d);
        }
    }

    bool inside() const { return from_ < end_; }
    double from() const { return from_; }
    double to() const { return std::min(end_, next_[nearest()]); }
    float majorant() const { return field_.majorants_[field_.index(cell_)]; }
    void go_on() {
        const std::size_t axis = nearest();
        from_ = std::max(from_, next_[axis]);
        next_[axis] += stride_[axis];
        cell_[axis] += step_[axis];
        if (cell_[axis] < 0 || cell_[axis] >= field_.cells_[axis]) end_ = from_;
    }

  private:
    static constexpr double kNever = std::numeric_limits<double>::infinity();

    std::size_t nearest() const {
        return std::size_t(std::min_element(next_.begin(), next_.end()) - next_.begin());
    }

    const BoundedField& field_;
    double from_ = 0, end_ = 0;
    std::array<int, 3> cell_{}, step_{};
    std::array<double, 3> next_{kNever, kNever, kNever}, stride_{kNever, kNever, kNever};
};

template <class Collide>
bool BoundedField::fly(const Vec3& origin, const Vec3& direction, float length, std::uint64_t seed,
                       Collide&& collide) const {
    FlightNumbers numbers(seed);
    double depth = -std::log1p(-double(numbers.next()));
    for (Cells cells(*this, origin, direction, double(length)); cells.inside(); cells.go_on()) {
        const double majorant = double(cells.majorant());
        double at = cells.from();
        while (depth < majorant * (cells.to() - at)) {
            at += depth / majorant;
            const auto distance = float(at);
            const MediumCoefficients here = this->at(origin + direction * distance);
            // By rounding the place may be the next cell's, whose most is greater.
            const float most = std::max(cells.majorant(), max_component(here.extinction()));
            if (collide(distance, here, most)) return true;
            depth = -std::log1p(-double(numbers.next()));
        }
        depth -= majorant * (cells.to() - at);
    }
    return false;
}

}  // namespace lxs
