// Rays across a beam.
#include "media/beam_boundary.h"

#include <algorithm>
#include <memory_resource>

#include "aips/adapter/scene.h"
#include "aips/core/base/constants.h"
#include "base/assign_all.h"
#include "base/constants.h"
#include "estimate/constants.h"
#include "media/constants.h"

namespace aips {
namespace {

constexpr std::size_t kMarks = std::size_t{1} << 16;

/// Most that a photon counts for: in sheets much thinner than the radius, seen along them, a photon
/// would be a spot.
constexpr float kMostFactor = 16;

/// Mark of the part of the image that a film position is in, `columns` and `rows` beside it.
std::size_t mark_of(Vec2 film, int columns, int rows) {
    const auto cell = [](float x, int beside) {
        return std::uint32_t(std::clamp(x, 0.0f, 1e9f)) / kFilmCell + std::uint32_t(beside);
    };
    return (cell(film.x, columns) * 0x9E3779B9u ^ cell(film.y, rows) * 0x85EBCA6Bu) >> 7 &
           (kMarks - 1);
}

}  // namespace

BeamBoundary::BeamBoundary(const Scene& scene) : scene_(scene), marks_(kMarks) {}

void BeamBoundary::begin_pass(std::uint64_t pass, float time, std::size_t beams) {
    pass_ = pass;
    time_ = time;
    assign_all(found_, beams, std::uint8_t{0});
}

std::uint32_t BeamBoundary::asks(const VolumeBeam& beam, std::size_t number, Vec2 film) const {
    if (found_[number] != 0 || marks_[mark_of(film, 0, 0)] != 0) return kAsksAtBoundary;
    const bool one = pass_ < kWarmUpPasses || (beam.sample + pass_) % kLateOneOf == 0;
    return one ? 1 : 0;
}

float BeamBoundary::way(Vec3 from, Vec3 direction, float farthest) const {
    Ray ray;
    ray.origin = from;
    ray.direction = direction;
    ray.time = time_;
    std::pmr::monotonic_buffer_resource memory;
    SurfacePoint met;
    return scene_.intersect_shape(ray, met, memory) ? std::min(met.distance, farthest) : farthest;
}

float BeamBoundary::factor(const VolumeBeam& beam, std::size_t number, float distance, Vec3 photon,
                           float radius) {
    const Vec3 place = beam.at(distance);
    const Vec3 aside = photon - place;
    const float off = length(aside);
    if (!(off > 0)) return 1;
    const Vec3 direction = aside / off;
    const float there = way(place, direction, radius);
    if (there < off) {
        found_[number] = 1;
        return 0;
    }
    const float back = way(place, -direction, radius);
    if (there >= radius && back >= radius) return 1;
    found_[number] = 1;
    return std::min(2 * radius * radius / (there * there + back * back), kMostFactor);
}

void BeamBoundary::end_pass(std::span<const VolumeBeam> beams, std::span<const Vec2> films) {
    for (std::uint8_t& mark : marks_)
        mark -= mark > 0;
    for (std::size_t i = 0; i < beams.size(); ++i) {
        if (!found_[i]) continue;
        for (int row = -1; row <= 1; ++row) {
            for (int column = -1; column <= 1; ++column)
                marks_[mark_of(films[beams[i].sample], column, row)] = kEdgePasses;
        }
    }
}

void BeamBoundary::state(StateArchive& archive) {
    archive.fixed(marks_);
    for (const std::uint8_t mark : marks_)
        StateArchive::check(mark <= kEdgePasses, "parts of the image where media end");
}

std::size_t BeamBoundary::memory_bound_bytes(std::size_t beams) {
    return kMarks + beams;
}

}  // namespace aips
