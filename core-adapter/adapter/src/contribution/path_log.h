// What is remembered of photon paths that a guide learns from.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "aips/adapter/scene.h"
#include "aips/core/photon_map/photon.h"
#include "aips/core/trees/primary_tree.h"
#include "contribution/constants.h"

namespace aips {

/// How many photons go on from a vertex, on average: below 1 that is a probability, above 1 the
/// photon is split.
struct Survival {
    float photons = 1;
    /// What either way of deciding would make of the photon, before limits: proportional to the
    /// photon's power. A negative score: nothing is known of the place, the plain way decides.
    float plain = 1;
    float scored = -1;
    float most = kMostPhotons;  ///< photons that go on at the most, whatever their score
};

/// How far scores decide on survival: what is known of them is noisy, and they alone would end
/// photons that matter (docs/notebook/2026-11-22-survival-by-score.md). With s by power and t by
/// score,
enum class ScoreMix : std::uint8_t {
    None,     ///< s
    Half,     ///< s^(1/2) t^(1/2)
    Quarters  ///< s^(1/4) t^(3/4)
};

/// Within limits; NaN, of a score or an albedo that is none, is the lower one.
inline float limited_photons(float photons, float most) {
    return photons > kMinSurvival ? std::min(photons, most) : kMinSurvival;
}

/// Photons that go on when `mix` decides, within its limits, for `power` times the photon's power.
/// Never below kMinSurvival, whatever the numbers.
inline float photons_going_on(const Survival& s, ScoreMix mix, float power) {
    if (mix == ScoreMix::None || s.scored < 0) {
        return limited_photons(s.plain * power, 1);
    }
    float mixed = std::sqrt(s.plain * s.scored);
    if (mix == ScoreMix::Quarters) mixed = std::sqrt(mixed * s.scored);
    return limited_photons(mixed * power, s.most);
}

/// A vertex that a photon went on from; it then left by a direction drawn, or was absorbed. Of
/// photons that were split here the path goes on with the first.
struct PathVertex {
    Vec3 position;
    Vec3 normal;              ///< unit geometric normal, on the side that the photon arrived at
    float power = 0;          ///< luminance of the arriving power, divided by the photons going on
    Survival survival;        ///< roulette before it
    std::uint32_t rays = 0;   ///< that the path had traced up to here
    std::uint32_t depth = 0;  ///< surfaces met, this one included
    Vec3 direction;           ///< unit, by which it left
    float pdf = 0;  ///< per steradian, with which that was drawn; 0: a specular lobe, or absorbed
    float plain_pdf = 0;  ///< what it would have been without a guide of directions
    LobeMask lobes = 0;   ///< of the surface
};

/// A path as a whole. Indices are into the log's vertices and photons.
struct PathRecord {
    LightIndex light = kNoLight;
    PrimaryPoint start{};
    double pdf = 0;  ///< of light and start, over all lights' primary coordinates
    std::uint32_t rays = 0;
    std::uint32_t first_vertex = 0, vertices = 0;
    std::uint32_t first_photon = 0, photons = 0;
};

/// Paths in their order.
struct PathLog {
    std::vector<PathRecord> paths;
    std::vector<PathVertex> vertices;
    /// Of logged paths alone, at the power that they carried. None while paths are traced: then
    /// indices are into the photons of the block.
    std::vector<Photon> photons;

    void clear() {
        paths.clear();
        vertices.clear();
        photons.clear();
    }
    std::size_t memory_bytes() const {
        return paths.capacity() * sizeof(PathRecord) + vertices.capacity() * sizeof(PathVertex) +
               photons.capacity() * sizeof(Photon);
    }
};

/// Of a log, or where its parts begin.
struct PathLogSize {
    std::size_t paths = 0, vertices = 0, photons = 0;

    static PathLogSize of(const PathLog& log);
    PathLogSize& operator+=(const PathLogSize& other);
};

/// What a block of paths left.
struct BlockOfPaths {
    const PathLog& log;
    std::span<const Photon> photons;  ///< of all paths, logged or not
};

/// Appends the logs of `count` blocks, in their order, to `log`, on all threads.
void append_logs(std::size_t count, const std::function<BlockOfPaths(std::size_t)>& block,
                 PathLog& log);

}  // namespace aips
