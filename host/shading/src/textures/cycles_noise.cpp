// The noises of Cycles, number for number.
#include "cycles_noise.h"

#include <algorithm>
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

float gradient(Bits hash, float x, float y, float z) {
    const Bits h = hash & 15;
    const float u = h < 8 ? x : y;
    const float v = h < 4 ? y : h == 12 || h == 14 ? x : z;
    return (h & 1 ? -u : u) + (h & 2 ? -v : v);
}

/// Moves places apart, by a number that tells uses apart.
Vec3 offset(float seed) {
    const auto one = [&](float k) { return 100 + 100 * unit(hashed(bits(seed), bits(k))); };
    return {one(0), one(1), one(2)};
}

Vec3 distorted(const Vec3& p, float distortion) {
    if (distortion == 0) return p;
    return p + Vec3(signed_noise(p + offset(0)), signed_noise(p + offset(1)),
                    signed_noise(p + offset(2))) *
                   distortion;
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

/// Calls `visit`(cell's offset, its point from the cell of `p`) for cells up to `reach` away.
template <class Visit>
void visit_cells(const Vec3& cell, float randomness, int reach, Visit visit) {
    for (int k = -reach; k <= reach; ++k) {
        for (int j = -reach; j <= reach; ++j) {
            for (int i = -reach; i <= reach; ++i) {
                const Vec3 step(static_cast<float>(i), static_cast<float>(j),
                                static_cast<float>(k));
                visit(step, step + hash_color(cell + step) * randomness);
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

float signed_noise(const Vec3& p) {
    const Vec3 cell = floor_of(p), f = p - cell;
    const auto corner = [&](int dx, int dy, int dz) {
        const auto at = [](float c, int d) {
            return static_cast<Bits>(static_cast<std::int64_t>(c) + d);
        };
        const Bits h = hashed(at(cell.x, dx), at(cell.y, dy), at(cell.z, dz));
        return gradient(h, f.x - static_cast<float>(dx), f.y - static_cast<float>(dy),
                        f.z - static_cast<float>(dz));
    };
    const float u = faded(f.x), v = faded(f.y), w = faded(f.z);
    const auto row = [&](int dy, int dz) {
        return (1 - u) * corner(0, dy, dz) + u * corner(1, dy, dz);
    };
    const auto sheet = [&](int dz) { return (1 - v) * row(0, dz) + v * row(1, dz); };
    const float sum = (1 - w) * sheet(0) + w * sheet(1);
    return std::isfinite(sum) ? 0.9820f * sum : 0;
}

float noise(const Vec3& p, const Octaves& octaves) {
    constexpr float kMostOctaves = 15;
    const float detail = std::clamp(octaves.detail, 0.0f, kMostOctaves);
    const float roughness = std::max(octaves.roughness, 0.0f);
    const float whole = std::floor(detail), rest = detail - whole;
    float sum = 0, amplitude = 1, most = 0, scale = 1;
    for (int i = 0; i <= static_cast<int>(whole); ++i) {
        sum += signed_noise(p * scale) * amplitude;
        most += amplitude;
        amplitude *= roughness;
        scale *= octaves.lacunarity;
    }
    const float first = 0.5f * sum / most + 0.5f;
    if (rest == 0) return first;
    sum += signed_noise(p * scale) * amplitude;
    return first + rest * (0.5f * sum / (most + amplitude) + 0.5f - first);
}

float distorted_noise(Vec3 p, const Octaves& octaves, float distortion) {
    return noise(distorted(p, distortion), octaves);
}

Vec3 distorted_noise_color(Vec3 p, const Octaves& octaves, float distortion) {
    p = distorted(p, distortion);
    return {noise(p, octaves), noise(p + offset(3), octaves), noise(p + offset(4), octaves)};
}

Cell nearest_cell(const Vec3& p, const CellShape& shape) {
    const Vec3 cell = floor_of(p), local = p - cell;
    Cell found;
    found.distance = std::numeric_limits<float>::max();
    Vec3 of(0.0f);
    visit_cells(cell, shape.randomness, 1, [&](const Vec3& step, const Vec3& point) {
        const float d = distance(point, local, shape);
        if (d >= found.distance) return;
        found.distance = d;
        found.position = point + cell;
        of = step;
    });
    found.color = hash_color(cell + of);
    return found;
}

Cell second_cell(const Vec3& p, const CellShape& shape) {
    const Vec3 cell = floor_of(p), local = p - cell;
    Cell first, second;
    first.distance = second.distance = std::numeric_limits<float>::max();
    Vec3 of_first(0.0f), of_second(0.0f);
    visit_cells(cell, shape.randomness, 1, [&](const Vec3& step, const Vec3& point) {
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
    second.color = hash_color(cell + of_second);
    return second;
}

Cell smooth_cell(const Vec3& p, const CellShape& shape) {
    const Vec3 cell = floor_of(p), local = p - cell;
    // Blender's 1 is Cycles' 0.5.
    const float smoothness = std::clamp(shape.smoothness / 2, 1e-5f, 0.5f);
    Cell sum;
    float smooth = 8;
    visit_cells(cell, shape.randomness, 2, [&](const Vec3& step, const Vec3& point) {
        const float d = distance(point, local, shape);
        const float t = std::clamp(0.5f + 0.5f * (smooth - d) / smoothness, 0.0f, 1.0f);
        const float h = t * t * (3 - 2 * t);
        float bend = smoothness * h * (1 - h);
        smooth += (d - smooth) * h - bend;
        bend /= 1 + 3 * smoothness;
        sum.color += (hash_color(cell + step) - sum.color) * h - Vec3(bend);
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
    visit_cells(cell, shape.randomness, 1, [&](const Vec3&, const Vec3& point) {
        const Vec3 to = point - local;
        if (to.dot(to) >= least) return;
        least = to.dot(to);
        nearest = to;
    });
    least = std::numeric_limits<float>::max();
    visit_cells(cell, shape.randomness, 1, [&](const Vec3&, const Vec3& point) {
        const Vec3 to = point - local, across = to - nearest;
        if (across.dot(across) <= 1e-4f) return;
        least = std::min(least, ((nearest + to) / 2).dot(across.normalized()));
    });
    return least;
}

}  // namespace lxs::shading::cycles
