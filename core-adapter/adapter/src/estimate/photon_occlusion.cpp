// Rays between photons and visible points, and where they pay.
#include "estimate/photon_occlusion.h"

#include <algorithm>
#include <cmath>

#include "aips/core/base/constants.h"
#include "base/assign_all.h"
#include "base/constants.h"
#include "base/film_pixel.h"
#include "estimate/constants.h"

namespace aips {
namespace {

/// Height of the ray between a photon and a visible point above their surfaces: what is thinner
/// does not separate them (radii).
constexpr float kOcclusionClearance = 1e-3f;

/// The same for rounding: 16 steps between floats at the greatest coordinate.
constexpr float kOcclusionRounding = 16 * 0x1p-23f;

/// Passes for which photons are asked for after the last one was separated.
constexpr std::uint8_t kOcclusionPasses = kEdgePasses;

}  // namespace

float occlusion_clearance(Vec3 a, Vec3 b, float radius) {
    const float largest = std::max(
        {std::abs(a.x), std::abs(a.y), std::abs(a.z), std::abs(b.x), std::abs(b.y), std::abs(b.z)});
    return kOcclusionClearance * radius + kOcclusionRounding * largest;
}

// Where a smooth surface curves away between the two points, each lies below the tangent plane of
// the other, and the surface between them below both planes. At distances a and b from the line
// where the planes meet, turned by t, the drops are b sin t and a sin t. Ends that are lifted by h
// along their normals clear that line if h >= min(a, b) tan t, the smaller drop over cos t. Two
// parallel sheets are below and above each other: nothing is lifted, and the one separates the
// other.
bool separated(const Scene& scene, const VisiblePoint& point, Vec3 position, Vec3 normal,
               float radius, float time) {
    const bool same_way = dot(normal, point.geometric_normal) > 0;
    const Vec3 own = same_way ? point.geometric_normal : -point.geometric_normal;
    const Vec3 between = position - point.position;
    const float drop = std::min(-dot(between, own), dot(between, normal));
    const float bulge = drop / std::max(dot(own, normal), kMinNormalAgreement);
    const float lift =
        std::max(bulge, 0.0f) + occlusion_clearance(point.position, position, radius);
    if (length_squared(between) <= 4 * lift * lift) return false;
    return scene.blocked(point.position + own * lift, position + normal * lift, time);
}

PhotonOcclusion::PhotonOcclusion(const Scene& scene, std::uint64_t seed, std::uint32_t width,
                                 std::uint32_t height)
    : scene_(scene),
      seed_(seed),
      width_(width),
      height_(height),
      columns_(film_cells_along(width)),
      rows_(film_cells_along(height)) {
    marks_.resize(std::size_t{columns_} * rows_);
    all_.resize(marks_.size());
    reached_.resize(marks_.size());
}

std::size_t PhotonOcclusion::cell_of(Vec2 film_position) const {
    return film_cell(film_pixel(film_position, width_, height_), width_);
}

void PhotonOcclusion::begin_pass(std::uint64_t pass, float time, const EyeImage& image) {
    pass_ = pass;
    time_ = time;
    assign_all(found_, image.visible_points.size(), std::uint8_t{0}, image.positions.size());
    assign_all(squares_, image.visible_points.size(), Squares{}, image.positions.size());
}

OcclusionTest PhotonOcclusion::test_of(const VisiblePoint& point, std::size_t number,
                                       Vec2 film_position) const {
    if (found_[number] || asks_all(film_position)) return OcclusionTest::All;
    const bool asks = pass_ < kWarmUpPasses || (point.sample + pass_) % kLateOneOf == 0;
    return asks ? OcclusionTest::Some : OcclusionTest::None;
}

RandomStream PhotonOcclusion::numbers(const VisiblePoint& point) const {
    return {seed_, pass_, point.sample, RandomDomain::Occlusion};
}

void PhotonOcclusion::exchange(std::uint32_t rank, StateArchive& archive,
                               const PointOwners& owners) {
    plain_of_points(archive, owners, rank, found_);
    plain_of_points(archive, owners, rank, squares_);
}

void PhotonOcclusion::end_pass(const EyeImage& image) {
    for (std::size_t cell = 0; cell < marks_.size(); ++cell) {
        if (marks_[cell]) --marks_[cell];
        all_[cell] *= kOcclusionMemory;
        reached_[cell] *= kOcclusionMemory;
    }
    for (std::size_t i = 0; i < found_.size(); ++i) {
        if (!found_[i] && !(squares_[i].all > 0)) continue;
        const std::size_t cell = cell_of(image.positions[image.visible_points[i].sample]);
        if (found_[i]) mark_around(cell);
        if (!std::isfinite(squares_[i].all)) continue;
        all_[cell] += squares_[i].all;
        reached_[cell] += squares_[i].reached;
    }
}

/// And its neighbours: the wall goes on.
void PhotonOcclusion::mark_around(std::size_t cell) {
    const auto column = std::uint32_t(cell % columns_), row = std::uint32_t(cell / columns_);
    for (std::uint32_t y = row - (row > 0); y <= std::min(row + 1, rows_ - 1); ++y) {
        for (std::uint32_t x = column - (column > 0); x <= std::min(column + 1, columns_ - 1); ++x)
            marks_[std::size_t{y} * columns_ + x] = kOcclusionPasses;
    }
}

float PhotonOcclusion::reached_share(Vec2 film_position) const {
    const std::size_t cell = cell_of(film_position);
    if (!marks_[cell] || !(all_[cell] > 0)) return 1;
    return std::min(reached_[cell] / all_[cell], 1.0f);
}

void PhotonOcclusion::state(StateArchive& archive) {
    archive.fixed(marks_);
    archive.fixed(all_);
    archive.fixed(reached_);
    for (std::size_t cell = 0; cell < marks_.size(); ++cell) {
        StateArchive::check(marks_[cell] <= kOcclusionPasses, "parts of the image with walls");
        StateArchive::check(
            std::isfinite(all_[cell]) && reached_[cell] >= 0 && all_[cell] >= reached_[cell],
            "photons behind walls");
    }
}

std::size_t PhotonOcclusion::memory_bytes() const {
    return marks_.capacity() + (all_.capacity() + reached_.capacity()) * sizeof(float) +
           found_.capacity() + squares_.capacity() * sizeof(Squares);
}

std::size_t PhotonOcclusion::memory_bound_bytes(std::size_t pixels, std::size_t visible_points) {
    // A cell has a pixel at least.
    return pixels * (1 + 2 * sizeof(float)) + visible_points * (1 + sizeof(Squares));
}

}  // namespace aips
