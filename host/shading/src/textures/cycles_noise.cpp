// The noises of Cycles, number for number.
#include "cycles_noise.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace lxs::shading::cycles {
namespace {

using Bits = std::uint32_t;

/// Jenkins' lookup3: what it ends with, of three words.
Bits finished(Bits a, Bits b, Bits c) {
    c ^= b;
    c -= std::rotl(b, 14);
    a ^= c;
    a -= std::rotl(c, 11);
    b ^= a;
    b -= std::rotl(a, 25);
    c ^= b;
    c -= std::rotl(b, 16);
    a ^= c;
    a -= std::rotl(c, 4);
    b ^= a;
    b -= std::rotl(a, 14);
    c ^= b;
    c -= std::rotl(b, 24);
    return c;
}

constexpr Bits start(Bits words) {
    return 0xdeadbeefu + (words << 2) + 13;
}

Bits hashed(Bits x) {
    const Bits s = start(1);
    return finished(s + x, s, s);
}

Bits hashed(Bits x, Bits y) {
    const Bits s = start(2);
    return finished(s + x, s + y, s);
}

Bits hashed(Bits x, Bits y, Bits z) {
    const Bits s = start(3);
    return finished(s + x, s + y, s + z);
}

Bits hashed(Bits x, Bits y, Bits z, Bits w) {
    Bits a = start(4) + x, b = start(4) + y, c = start(4) + z;
    a -= c;
    a ^= std::rotl(c, 4);
    c += b;
    b -= a;
    b ^= std::rotl(a, 6);
    a += c;
    c -= b;
    c ^= std::rotl(b, 8);
    b += a;
    a -= c;
    a ^= std::rotl(c, 16);
    c += b;
    b -= a;
    b ^= std::rotl(a, 19);
    a += c;
    c -= b;
    c ^= std::rotl(b, 4);
    b += a;
    return finished(a + w, b, c);
}

float unit(Bits bits) {
    return static_cast<float>(bits) / static_cast<float>(0xffffffffu);
}

Bits bits(float x) {
    return std::bit_cast<Bits>(x);
}

float faded(float t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

using Coordinates = std::array<float, 4>;

/// Those that count, in the order that hashes take them.
Coordinates coordinates_of(const Place& place) {
    if (place.dimensions == 1) return {place.w, 0, 0, 0};
    return {place.p.x, place.p.y, place.p.z, place.w};
}

float negated(float x, Bits if_any) {
    return if_any ? -x : x;
}

float gradient(Bits hash, const Coordinates& c, int dimensions) {
    const auto [x, y, z, w] = c;
    if (dimensions == 1) {
        const Bits h = hash & 15;
        return negated(1 + static_cast<float>(h & 7), h & 8) * x;
    }
    if (dimensions == 2) {
        const Bits h = hash & 7;
        return negated(h < 4 ? x : y, h & 1) + negated(2 * (h < 4 ? y : x), h & 2);
    }
    if (dimensions == 3) {
        const Bits h = hash & 15;
        const float v = h < 4 ? y : h == 12 || h == 14 ? x : z;
        return negated(h < 8 ? x : y, h & 1) + negated(v, h & 2);
    }
    const Bits h = hash & 31;
    return negated(h < 24 ? x : y, h & 1) + negated(h < 16 ? y : z, h & 2) +
           negated(h < 8 ? z : w, h & 4);
}

Bits hashed_cell(const std::array<Bits, 4>& c, int dimensions) {
    switch (dimensions) {
        case 1:
            return hashed(c[0]);
        case 2:
            return hashed(c[0], c[1]);
        case 3:
            return hashed(c[0], c[1], c[2]);
        default:
            return hashed(c[0], c[1], c[2], c[3]);
    }
}

/// Moves places apart, by a number that tells uses apart.
Place moved(const Place& place, float seed) {
    const auto offset = [&](float k) { return 100 + 100 * unit(hashed(bits(seed), bits(k))); };
    if (place.dimensions == 1) return {place.p, place.w + 100 + 100 * unit(hashed(bits(seed))), 1};
    return {place.p + Vec3(offset(0), offset(1), offset(2)), place.w + offset(3), place.dimensions};
}

Place distorted(const Place& place, float by) {
    if (by == 0) return place;
    const auto shift = [&](float seed) { return signed_noise(moved(place, seed)) * by; };
    if (place.dimensions == 1) return {place.p, place.w + shift(0), 1};
    Place found = place;
    found.p += Vec3(shift(0), shift(1), place.dimensions > 2 ? shift(2) : 0);
    if (place.dimensions == 4) found.w += shift(3);
    return found;
}

float distance(const Vec3& a, const Vec3& b, const CellShape& shape) {
    const Vec3 d(std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z));
    switch (shape.metric) {
        case Metric::Manhattan:
            return d.x + d.y + d.z;
        case Metric::Chebychev:
            return std::max({d.x, d.y, d.z});
        case Metric::Minkowski: {
            const float e = shape.exponent;
            return std::pow(std::pow(d.x, e) + std::pow(d.y, e) + std::pow(d.z, e), 1 / e);
        }
        case Metric::Euclidean:
            break;
    }
    return d.length();
}

Vec3 floor_of(const Vec3& p) {
    return {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
}

Vec3 hash_flat(const Vec3& p) {
    const Bits x = bits(p.x), y = bits(p.y);
    return {unit(hashed(x, y)), unit(hashed(x, y, bits(1.0f))), unit(hashed(x, y, bits(2.0f)))};
}

Vec3 color_of_cell(const Vec3& cell, const CellShape& shape) {
    return shape.flat ? hash_flat(cell) : hash_color(cell);
}

/// Calls `visit`(cell's offset, its point from the cell of `p`) for cells up to `reach` away.
template <class Visit>
void visit_cells(const Vec3& cell, const CellShape& shape, int reach, Visit visit) {
    const int up = shape.flat ? 0 : reach;
    for (int k = -up; k <= up; ++k) {
        for (int j = -reach; j <= reach; ++j) {
            for (int i = -reach; i <= reach; ++i) {
                const Vec3 step(static_cast<float>(i), static_cast<float>(j),
                                static_cast<float>(k));
                Vec3 within = color_of_cell(cell + step, shape);
                if (shape.flat) within.z = 0;
                visit(step, step + within * shape.randomness);
            }
        }
    }
}

}  // namespace

float hash(const Vec3& p) {
    return unit(hashed(bits(p.x), bits(p.y), bits(p.z)));
}

Vec3 hash_color(const Vec3& p) {
    const Bits x = bits(p.x), y = bits(p.y), z = bits(p.z);
    return {hash(p), unit(hashed(x, y, z, bits(1.0f))), unit(hashed(x, y, z, bits(2.0f)))};
}

float signed_noise(const Place& place) {
    constexpr std::array<float, 4> kScales{0.2500f, 0.6616f, 0.9820f, 0.8344f};
    const int dimensions = place.dimensions;
    const Coordinates c = coordinates_of(place);
    std::array<std::int64_t, 4> cell{};
    Coordinates fraction{}, share{};
    for (int d = 0; d < dimensions; ++d) {
        const float floor = std::floor(c[d]);
        if (!(std::abs(floor) < 1e18f)) return 0;
        cell[d] = static_cast<std::int64_t>(floor);
        fraction[d] = c[d] - floor;
        share[d] = faded(fraction[d]);
    }
    float sum = 0;
    for (int corner = 0; corner < 1 << dimensions; ++corner) {
        std::array<Bits, 4> at{};
        Coordinates from{};
        float weight = 1;
        for (int d = 0; d < dimensions; ++d) {
            const int up = corner >> d & 1;
            at[d] = static_cast<Bits>(cell[d] + up);
            from[d] = fraction[d] - static_cast<float>(up);
            weight *= up ? share[d] : 1 - share[d];
        }
        sum += weight * gradient(hashed_cell(at, dimensions), from, dimensions);
    }
    return kScales[dimensions - 1] * sum;
}

float noise(const Place& place, const Octaves& octaves) {
    constexpr float kMostOctaves = 15;
    const float detail = std::clamp(octaves.detail, 0.0f, kMostOctaves);
    const float roughness = std::max(octaves.roughness, 0.0f);
    const float whole = std::floor(detail), rest = detail - whole;
    float sum = 0, amplitude = 1, most = 0, scale = 1;
    for (int i = 0; i <= static_cast<int>(whole); ++i) {
        sum += signed_noise(place * scale) * amplitude;
        most += amplitude;
        amplitude *= roughness;
        scale *= octaves.lacunarity;
    }
    const float first = 0.5f * sum / most + 0.5f;
    if (rest == 0) return first;
    sum += signed_noise(place * scale) * amplitude;
    return first + rest * (0.5f * sum / (most + amplitude) + 0.5f - first);
}

float distorted_noise(const Place& place, const Octaves& octaves, float distortion) {
    return noise(distorted(place, distortion), octaves);
}

Vec3 distorted_noise_color(const Place& place, const Octaves& octaves, float distortion) {
    const Place p = distorted(place, distortion);
    const auto own = static_cast<float>(place.dimensions);  // seeds below are those of distortion
    return {noise(p, octaves), noise(moved(p, own), octaves), noise(moved(p, own + 1), octaves)};
}

Cell nearest_cell(const Vec3& p, const CellShape& shape) {
    const Vec3 cell = floor_of(p), local = p - cell;
    Cell found;
    found.distance = std::numeric_limits<float>::max();
    Vec3 of(0.0f);
    visit_cells(cell, shape, 1, [&](const Vec3& step, const Vec3& point) {
        const float d = distance(point, local, shape);
        if (d >= found.distance) return;
        found.distance = d;
        found.position = point + cell;
        of = step;
    });
    found.color = color_of_cell(cell + of, shape);
    return found;
}

Cell second_cell(const Vec3& p, const CellShape& shape) {
    const Vec3 cell = floor_of(p), local = p - cell;
    Cell first, second;
    first.distance = second.distance = std::numeric_limits<float>::max();
    Vec3 of_first(0.0f), of_second(0.0f);
    visit_cells(cell, shape, 1, [&](const Vec3& step, const Vec3& point) {
        const float d = distance(point, local, shape);
        if (d < first.distance) {
            second = first;
            of_second = of_first;
            first.distance = d;
            first.position = point + cell;
            of_first = step;
        } else if (d < second.distance) {
            second.distance = d;
            second.position = point + cell;
            of_second = step;
        }
    });
    second.color = color_of_cell(cell + of_second, shape);
    return second;
}

Cell smooth_cell(const Vec3& p, const CellShape& shape) {
    const Vec3 cell = floor_of(p), local = p - cell;
    // Blender's 1 is Cycles' 0.5.
    const float smoothness = std::clamp(shape.smoothness / 2, 1e-5f, 0.5f);
    Cell sum;
    float smooth = 8;
    visit_cells(cell, shape, 2, [&](const Vec3& step, const Vec3& point) {
        const float d = distance(point, local, shape);
        const float t = std::clamp(0.5f + 0.5f * (smooth - d) / smoothness, 0.0f, 1.0f);
        const float h = t * t * (3 - 2 * t);
        float bend = smoothness * h * (1 - h);
        smooth += (d - smooth) * h - bend;
        bend /= 1 + 3 * smoothness;
        sum.color += (color_of_cell(cell + step, shape) - sum.color) * h - Vec3(bend);
        sum.position += (point - sum.position) * h - Vec3(bend);
    });
    sum.distance = smooth;
    sum.position += cell;
    return sum;
}

float distance_to_edge(const Vec3& p, const CellShape& shape) {
    const Vec3 cell = floor_of(p), local = p - cell;
    Vec3 nearest(0.0f);
    float least = std::numeric_limits<float>::max();
    visit_cells(cell, shape, 1, [&](const Vec3&, const Vec3& point) {
        const Vec3 to = point - local;
        if (to.dot(to) >= least) return;
        least = to.dot(to);
        nearest = to;
    });
    least = std::numeric_limits<float>::max();
    visit_cells(cell, shape, 1, [&](const Vec3&, const Vec3& point) {
        const Vec3 to = point - local, across = to - nearest;
        if (across.dot(across) <= 1e-4f) return;
        least = std::min(least, ((nearest + to) / 2).dot(across.normalized()));
    });
    return least;
}

}  // namespace lxs::shading::cycles
