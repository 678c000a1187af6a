// A lamp of 2^20 triangles shines as the square that they make up: what is drawn among so many is
// what their densities say, however few of the steps of a random number one of them takes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "chi_square.h"
#include "light_cases.h"

namespace lxs::test::tessellated_lamp_test {
namespace {

constexpr float kHeight = 0.05f;      // of the lamp above the floor
constexpr std::uint32_t kSide = 512;  // squares a side of either part, of two triangles each
/// Width of the lamp's left part. A triangle of the right part and the next one, of the left, take
/// 30.6 and 1.4 steps of 2^-24.
constexpr double kLeft = 1.4 / 32;

/// Appends the grid's vertices between `low` and `high` in x.
void add_vertices(TriangleMesh& mesh, double low, double high) {
    for (std::uint32_t y = 0; y <= kSide; ++y) {
        for (std::uint32_t x = 0; x <= kSide; ++x)
            mesh.positions.emplace_back(float(low + (high - low) * x / kSide), float(y) / kSide,
                                        kHeight);
    }
}

/// The unit square above the floor, shining down. Large triangles, of its right part, and small
/// ones, of its left, take turns.
TriangleMesh square_of_two_grids() {
    TriangleMesh mesh;
    add_vertices(mesh, kLeft, 1);
    add_vertices(mesh, 0, kLeft);
    const auto left = static_cast<std::uint32_t>(mesh.positions.size() / 2);
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
        const std::uint32_t a = i / kSide * (kSide + 1) + i % kSide, b = a + kSide + 1;
        for (const auto& t : {std::array{a, b, a + 1}, std::array{b, b + 1, a + 1}}) {
            for (const std::uint32_t first : {0u, left})
                mesh.indices.insert(mesh.indices.end(), {first + t[0], first + t[1], first + t[2]});
        }
    }
    return mesh;
}

const Light& lamp() {
    static const auto light = make_area_light(emissive(square_of_two_grids(), Rgb(1.0f)), Matrix());
    return *light;
}

/// What a rectangle of radiance 1 with a corner above the point brings to it: `x` and `y` are the
/// sides over the height (Howell, configuration factor of a parallel rectangle, times pi).
double corner_irradiance(double x, double y) {
    const double a = std::sqrt(1 + x * x), b = std::sqrt(1 + y * y);
    return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / 2;
}

/// Irradiance of the floor's point (x, y) under the whole lamp.
double irradiance(double x, double y) {
    const auto of = [&](double to_x, double to_y) {
        return corner_irradiance((to_x - x) / kHeight, (to_y - y) / kHeight);
    };
    return of(1, 1) - of(0, 1) - of(1, 0) + of(0, 0);
}

/// A block of the floor: columns as wide as the left part is, then wider ones; rows of an eighth.
struct Block {
    double x0, x1, y0, y1;
    double area() const { return (x1 - x0) * (y1 - y0); }
    bool holds(double x, double y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
};

std::vector<Block> blocks() {
    const std::array columns = {0.0, kLeft, 2 * kLeft, 3 * kLeft, 0.25, 0.5, 0.75, 1.0};
    std::vector<Block> all;
    for (std::size_t c = 0; c + 1 < columns.size(); ++c) {
        for (int row = 0; row < 8; ++row)
            all.push_back({columns[c], columns[c + 1], row / 8.0, (row + 1) / 8.0});
    }
    return all;
}

double closed_form_flux(const Block& block) {
    constexpr int kPoints = 40;
    double sum = 0;
    for (int i = 0; i < kPoints * kPoints; ++i) {
        const int row = i / kPoints, column = i % kPoints;
        const double s = (row + 0.5) / kPoints, t = (column + 0.5) / kPoints;
        sum += irradiance(std::lerp(block.x0, block.x1, s), std::lerp(block.y0, block.y1, t));
    }
    return sum * block.area() / (kPoints * kPoints);
}

/// |z| < 4.5 in each of 56 blocks: below 0.1 % over all.
void expect_flux(const Block& block, double sum, double squares, double count) {
    const double mean = sum / count;
    const double error = std::sqrt((squares / count - mean * mean) / count);
    const double expected = closed_form_flux(block);
    EXPECT_LT(error / expected, 0.02) << "too noisy to tell";
    EXPECT_LT(std::abs(mean - expected) / error, 4.5)
        << "x from " << block.x0 << ", y from " << block.y0 << ": " << mean / expected;
}

TEST(TessellatedLamp, PhotonsOnTheFloorBlockByBlock) {
    constexpr int kPhotons = 2'000'000;
    const std::vector<Block> all = blocks();
    std::vector<double> sums(all.size()), squares(all.size());
    Random random(5);
    for (int i = 0; i < kPhotons; ++i) {
        EmissionSample s;
        ASSERT_TRUE(lamp().sample_emission({random(), random(), random(), random()}, s));
        const float t = -s.ray.origin.z / s.ray.direction.z;
        const double x = s.ray.origin.x + s.ray.direction.x * t;
        const double y = s.ray.origin.y + s.ray.direction.y * t;
        for (std::size_t b = 0; b < all.size(); ++b) {
            if (!all[b].holds(x, y)) continue;
            const double power = luminance(s.power);
            sums[b] += power;
            squares[b] += power * power;
        }
    }
    for (std::size_t b = 0; b < all.size(); ++b)
        expect_flux(all[b], sums[b], squares[b], kPhotons);
}

TEST(TessellatedLamp, DirectLightOnTheFloorBlockByBlock) {
    constexpr int kSamples = 400'000;
    Random random(7);
    for (const Block& block : blocks()) {
        if (block.y0 != 0.5) continue;
        double sum = 0, squares = 0;
        for (int i = 0; i < kSamples; ++i) {
            const Vec3 p(float(std::lerp(block.x0, block.x1, double(random()))),
                         float(std::lerp(block.y0, block.y1, double(random()))), 0);
            DirectSample s;
            ASSERT_TRUE(lamp().sample_direct(p, Vec3(0, 0, 1), Vec2(random(), random()), s));
            const double value = block.area() * luminance(s.radiance) * s.wi.z / s.pdf;
            sum += value;
            squares += value * value;
        }
        expect_flux(block, sum, squares, kSamples);
    }
}

/// Probability of triangle `i`, whose area is `area`, by what pdf_direct says.
double stated_probability(const Light& light, std::uint32_t i, double area) {
    const Vec3 up(0, 0, 1);
    return double(light.pdf_direct(Vec3(0.5f, 0.5f, kHeight - 1), up, up, Vec3(0.5f, 0.5f, kHeight),
                                   -up, i)) *
           area;
}

// Cells of 256 triangles of one part that follow one another.
TEST(TessellatedLamp, TrianglesAreDrawnAsOftenAsTheDensitySays) {
    constexpr int kDraws = 1 << 22;
    constexpr std::uint32_t kTriangles = 4 * kSide * kSide;
    const auto cell = [](std::uint32_t i) { return i / 512 * 2 + i % 2; };
    std::vector<double> counts(kTriangles / 256 + 1), shares(counts.size());
    const double square = 1.0 / (2 * kSide * kSide);
    for (std::uint32_t i = 0; i < kTriangles; ++i) {
        shares[cell(i)] += stated_probability(lamp(), i, square * (i % 2 == 0 ? 1 - kLeft : kLeft));
    }
    EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-6);
    Random random(11);
    for (int i = 0; i < kDraws; ++i) {
        DirectSample s;
        ASSERT_TRUE(
            lamp().sample_direct(Vec3(0.5f, 0.5f, 0), Vec3(0, 0, 1), Vec2(random(), random()), s));
        ++counts[cell(s.primitive)];
    }
    EXPECT_GT(chi_square_p(counts, shares, kDraws), one_of(1));
}

TEST(TessellatedLamp, StatedPdfEqualsPdfDirect) {
    Random random(13);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 p(random(), random(), 0);
        DirectSample s;
        ASSERT_TRUE(lamp().sample_direct(p, Vec3(0, 0, 1), Vec2(random(), random()), s));
        const float pdf = lamp().pdf_direct(p, Vec3(0, 0, 1), s.wi, p + s.wi * s.distance,
                                            Vec3(0, 0, -1), s.primitive);
        EXPECT_NEAR(pdf / s.pdf, 1, 1e-4);
    }
}

TEST(TessellatedLamp, EmissionCoordinatesLeadToTheSampledTriangle) {
    Random random(17);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 p(random(), random(), 0);
        DirectSample s;
        ASSERT_TRUE(lamp().sample_direct(p, Vec3(0, 0, 1), Vec2(random(), random()), s));
        PrimaryPoint u{};
        ASSERT_TRUE(lamp().emission_coordinates(p, s, u));
        EmissionSample emission;
        ASSERT_TRUE(lamp().sample_emission(u, emission));
        EXPECT_LT((emission.ray.origin - s.segment_end).length(), 2e-5f);
    }
}

}  // namespace
}  // namespace lxs::test::tessellated_lamp_test
