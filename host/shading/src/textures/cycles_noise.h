// The noises of Cycles, number for number: Blender's nodes look as they do by them.
//
// After Cycles' kernel (Apache License 2.0): Jenkins' hash (lookup3), Perlin's gradient noise,
// Worley's cells.
#pragma once

#include <cstdint>

#include "lxs/sdk/types.h"

namespace lxs::shading::cycles {

/// Uniform in [0, 1] by the bits of one to four numbers.
float hash(const Vec3& p);
Vec3 hash_color(const Vec3& p);

/// A place of one to four dimensions: w, xy, xyz, or xyz and w.
struct Place {
    Vec3 p{0.0f};
    float w = 0;
    int dimensions = 3;

    Place operator*(float scale) const { return {p * scale, w * scale, dimensions}; }
};

/// Perlin's noise, about -1 to 1.
float signed_noise(const Place& place);

/// How octaves add up; `detail` is their number less one, and may have a fraction.
struct Octaves {
    float detail = 2, roughness = 0.5f, lacunarity = 2;
};

/// Fractional Brownian motion, 0 to 1.
float noise(const Place& place, const Octaves& octaves);
/// The same with its place moved by noise, as node Noise Texture has it; three of them as a colour.
float distorted_noise(const Place& place, const Octaves& octaves, float distortion);
Vec3 distorted_noise_color(const Place& place, const Octaves& octaves, float distortion);

enum class Metric : std::uint8_t { Euclidean, Manhattan, Chebychev, Minkowski };

struct Cell {
    float distance = 0;
    Vec3 color{0.0f}, position{0.0f};
};
struct CellShape {
    float randomness = 1, exponent = 0.5f, smoothness = 1;
    Metric metric = Metric::Euclidean;
    bool flat = false;  ///< of two dimensions: places have a z of 0
};

Cell nearest_cell(const Vec3& p, const CellShape& shape);
Cell second_cell(const Vec3& p, const CellShape& shape);
Cell smooth_cell(const Vec3& p, const CellShape& shape);
float distance_to_edge(const Vec3& p, const CellShape& shape);

}  // namespace lxs::shading::cycles
