// Perlin's gradient noise and the sums over octaves that are made of it.
#include "perlin_noise.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace lxs::shading {
namespace {

// Permutation of the reference implementation that Perlin published with the paper.
constexpr std::array<std::uint8_t, 256> kPermutation = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103,
    30,  69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,
    197, 62,  94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174,
    20,  125, 136, 171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231,
    83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143,
    54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196,
    135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124,
    123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,
    182, 189, 28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101,
    155, 167, 43,  172, 9,   129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185,
    112, 104, 218, 246, 97,  228, 251, 34,  242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,
    51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,  181, 199, 106, 157, 184, 84,  204, 176,
    115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114, 67,  29,  24,  72,  243,
    141, 128, 195, 78,  66,  215, 61,  156, 180};

// The twelve directions to the middles of a cube's edges, four of them twice. The last four stand
// in the order of Pharr and Humphreys 2004, "Physically Based Rendering", section 11.6.1, whose
// noise LuxRender has.
constexpr std::array<std::array<std::int8_t, 3>, 16> kGradients = {{
    {1, 1, 0},
    {-1, 1, 0},
    {1, -1, 0},
    {-1, -1, 0},
    {1, 0, 1},
    {-1, 0, 1},
    {1, 0, -1},
    {-1, 0, -1},
    {0, 1, 1},
    {0, -1, 1},
    {0, 1, -1},
    {0, -1, -1},
    {1, 1, 0},
    {-1, 1, 0},
    {0, 1, -1},
    {0, -1, -1},
}};

std::uint8_t permuted(unsigned i) {
    return kPermutation[i & 255];
}

/// A lattice coordinate modulo 256, without overflow.
unsigned lattice(float floor) {
    return static_cast<unsigned>(floor - 256 * std::floor(floor / 256));
}

float fade(float t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

float mix(float t, float a, float b) {
    return a + t * (b - a);
}

}  // namespace

float perlin_noise(const Vec3& p) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return 0;
    const Vec3 cell(std::floor(p.x), std::floor(p.y), std::floor(p.z));
    const Vec3 d = p - cell;
    const unsigned x = lattice(cell.x), y = lattice(cell.y), z = lattice(cell.z);
    const auto corner = [&](unsigned i, unsigned j, unsigned k) {
        const auto& g = kGradients[permuted(permuted(permuted(x + i) + y + j) + z + k) & 15];
        return static_cast<float>(g[0]) * (d.x - static_cast<float>(i)) +
               static_cast<float>(g[1]) * (d.y - static_cast<float>(j)) +
               static_cast<float>(g[2]) * (d.z - static_cast<float>(k));
    };
    const float u = fade(d.x), v = fade(d.y);
    const auto plane = [&](unsigned k) {
        return mix(v, mix(u, corner(0, 0, k), corner(1, 0, k)),
                   mix(u, corner(0, 1, k), corner(1, 1, k)));
    };
    return mix(fade(d.z), plane(0), plane(1));
}

namespace {

constexpr float kLacunarity = 1.99f;  // not 2: the zeros of octaves shall not coincide

template <class Term>
float sum_over_octaves(Vec3 p, float roughness, int octaves, Term term) {
    float sum = 0, weight = 1;
    for (int i = 0; i < octaves; ++i) {
        sum += weight * term(perlin_noise(p));
        p *= kLacunarity;
        weight *= roughness;
    }
    return sum;
}

}  // namespace

float fractal_sum(const Vec3& p, float roughness, int octaves) {
    return sum_over_octaves(p, roughness, octaves, [](float n) { return n; });
}

float turbulence(const Vec3& p, float roughness, int octaves) {
    return sum_over_octaves(p, roughness, octaves, [](float n) { return std::abs(n); });
}

}  // namespace lxs::shading
