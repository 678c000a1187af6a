// The random numbers of one path as coordinates in primary sample space, drawn or mutated.
#pragma once

#include <cassert>
#include <span>
#include <vector>

#include "aips/core/mutation.h"
#include "aips/core/random.h"

namespace aips {

/// Coordinates of the emission: four for the light's, one to choose the light.
inline constexpr std::uint32_t kEmissionCoordinates = 5;
/// Coordinates of a bounce: survival, two for the direction, one for the lobe.
inline constexpr std::uint32_t kBounceCoordinates = 4;

/// Most coordinates of a path that meets up to `depth` surfaces.
constexpr std::size_t max_coordinates(std::uint32_t depth) {
    return kEmissionCoordinates + std::size_t{kBounceCoordinates} * depth;
}

/// The numbers of a path that is being traced. Each bounce has coordinates of its own, whether it
/// uses them or not, so that a coordinate keeps its meaning from one path to the next. They come
/// into being when they are asked for: number k of the stream makes coordinate k.
class PrimaryPath {
  public:
    /// Mutations of `from` where it has coordinates, with this exponent; drawn anew beyond its end
    /// (all of them when it is empty). What is used is kept in `used`, which must come in empty.
    PrimaryPath(const RandomStream& random, std::span<const Coordinate> from, float exponent,
                std::vector<Coordinate>& used)
        : random_(random), from_(from), exponent_(exponent), used_(used) {}

    /// Number `dimension` (< kEmissionCoordinates) of the emission, in [0, 1).
    float emission(std::uint32_t dimension) { return to_unit_float(coordinate(dimension)); }

    /// The numbers of the bounce at surface `depth`, from 1: at most kBounceCoordinates of them.
    PrimaryPath& bounce(std::uint32_t depth) {
        position_ = max_coordinates(depth - 1);
        end_ = position_ + kBounceCoordinates;
        return *this;
    }
    float next() {
        assert(position_ < end_);
        return to_unit_float(coordinate(position_++));
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
    std::size_t position_ = 0, end_ = 0;
};

}  // namespace aips
