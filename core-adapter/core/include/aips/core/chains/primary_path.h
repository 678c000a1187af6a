// The random numbers of one path as coordinates in primary sample space, drawn or mutated.
#pragma once

#include <span>
#include <vector>

#include "aips/core/chains/mutation.h"
#include "aips/core/sampling/primary_point.h"
#include "aips/core/sampling/random.h"

namespace aips {

/// Coordinates of the emission: four of the light's, one to choose the light.
inline constexpr std::uint32_t kStartCoordinates = 4;
inline constexpr std::uint32_t kEmissionCoordinates = kStartCoordinates + 1;
/// Coordinates of a bounce: as many as the longest one draws (scatter_photon.h holds who draws
/// what).
inline constexpr std::uint32_t kBounceCoordinates = 6;

/// Most coordinates of a path that meets up to `depth` surfaces.
constexpr std::size_t max_coordinates(std::uint32_t depth) {
    return kEmissionCoordinates + std::size_t{kBounceCoordinates} * depth;
}

/// The numbers of a path that is being traced. Each bounce has coordinates of its own, whether it
/// uses them or not, so that those of a bounce stay its own from one path to the next; within it
/// they go to whoever asks first, so that one may change its meaning with the surface. They come
/// into being when they are asked for, in their order.
///
/// No number is handed out twice. What is asked for at the deepest bounce so far, by any photon of
/// the path, comes from what is left of its coordinates. What is asked for beyond these, or at a
/// depth less than the deepest, is drawn anew, never kept and never mutated. In a chain such
/// numbers are further coordinates, as many as one likes, each proposed anew from the uniform
/// density whatever the state: the proposal stays symmetric on the extended space, and the chain
/// uniform on the visible part of it.
class PrimaryPath {
  public:
    /// Mutations of `from` where it has coordinates, with this exponent; drawn anew beyond its end
    /// (all of them when it is empty). What is used is kept in `used`; the coordinates that it
    /// comes with, the first ones, are given.
    PrimaryPath(const RandomStream& random, std::span<const Coordinate> from, float exponent,
                std::vector<Coordinate>& used)
        : random_(random), from_(from), exponent_(exponent), used_(used) {}

    /// Where the light emits.
    PrimaryPoint start() {
        coordinate(kStartCoordinates - 1);
        return primary_point({used_[0], used_[1], used_[2], used_[3]});
    }
    /// Chooses the light; in [0, 1).
    float light_choice() { return to_unit_float(coordinate(kStartCoordinates)); }

    /// The numbers of the bounce at surface `depth`, from 1. Asked again for the depth it is at, it
    /// goes on where it was.
    PrimaryPath& bounce(std::uint32_t depth) {
        if (depth > deepest_) {
            deepest_ = depth;
            position_ = max_coordinates(depth - 1);
            end_ = position_ + kBounceCoordinates;
        } else if (depth < deepest_) {
            position_ = end_;
        }
        return *this;
    }
    float next() {
        return position_ < end_ ? to_unit_float(coordinate(position_++)) : random_.next();
    }
    /// Two numbers, x first.
    Vec2 next2() {
        const float x = next();
        return {x, next()};
    }

  private:
    Coordinate coordinate(std::size_t index) {
        while (used_.size() <= index) {
            const std::uint32_t bits = random_.next_uint();
            const std::size_t k = used_.size();
            used_.push_back(k < from_.size() ? mutate(from_[k], bits, exponent_) : bits);
        }
        return used_[index];
    }

    RandomStream random_;
    std::span<const Coordinate> from_;
    float exponent_;
    std::vector<Coordinate>& used_;
    std::uint32_t deepest_ = 0;  // bounce that has begun
    std::size_t position_ = 0, end_ = 0;
};

}  // namespace aips
