// One photon path: emitted, scattered, and what it leaves where it lands.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "aips/adapter/guide.h"
#include "aips/adapter/ranks.h"
#include "aips/adapter/scene.h"
#include "aips/adapter/settings.h"
#include "aips/core/base/arena.h"
#include "aips/core/chains/primary_path.h"
#include "aips/core/photon_map/occupancy.h"
#include "aips/core/photon_map/photon.h"
#include "aips/core/photon_map/point_grid.h"
#include "aips/core/sampling/low_discrepancy.h"
#include "aips/core/sampling/random.h"
#include "aips/core/tables/discrete_distribution.h"
#include "contribution/path_log.h"
#include "guides/adaptive/emission_guide.h"
#include "guides/adaptive/score_survival.h"
#include "media/volume_gather.h"
#include "photons/bounce_statistics.h"
#include "photons/photon_statistics.h"
#include "sample_filter/invalid_sample_filter.h"

namespace aips {

/// Counts over photon paths.
struct PhotonCounts {
    std::uint64_t paths = 0;
    std::uint64_t guided_emissions = 0;  ///< of these, with a guide that knows where to start
    std::uint64_t rays = 0;
    std::uint64_t bounces = 0;         ///< scatterings through non-specular lobes
    std::uint64_t guided_bounces = 0;  ///< of these, directions drawn from the guide
    std::uint64_t photons = 0;         ///< stored, but for those that shadow rays own
    std::uint64_t split_off = 0;       ///< photons that came from splitting others
    /// Paths that roulette by score ended where roulette by power would have let them go on.
    std::uint64_t pruned = 0;
    PhotonStatistics statistics;  ///< empty unless the settings ask for transport statistics

    void clear() {
        PhotonStatistics kept = std::move(statistics);
        kept.clear();
        *this = {};
        statistics = std::move(kept);
    }
    PhotonCounts& operator+=(const PhotonCounts& other);
    /// Saves or restores the counts.
    void state(StateArchive& archive);
};

/// The parts that photon paths work with; frozen during an iteration.
struct PhotonInput {
    const Scene& scene;
    const Settings& settings;
    const DiscreteDistribution& light_choice;
    const DirectionGuide* guide = nullptr;     ///< of directions; null: unguided
    const OccupancyGrid* occupancy = nullptr;  ///< photons elsewhere are not stored; null: all are
    std::uint64_t pass = 0;
    /// Number in the render of the path that the sequence of emissions begins at (SequencePath).
    std::uint64_t sequence_begin = 0;
    float time = 0;
    Ranks* ranks = nullptr;               ///< that share the paths of an iteration; null: none do
    BounceStatistics* bounces = nullptr;  ///< counts bounces by node, for debug layers; may be null
    bool store_owned = false;             ///< photons that shadow rays own too, marked, for a guide
    const PointGrid* reach = nullptr;     ///< with occupancy: the exact test; may be null
    const EmissionGuide* emission = nullptr;  ///< null: lights by power, uniform coordinates
    const ScoreSurvival* survival = nullptr;  ///< what photons may still bring; null: not known
    ScoreMix score_mix = ScoreMix::None;      ///< how far it decides
    std::size_t split_limit = 0;   ///< no photon is split while more photons are in the block
    std::uint32_t log_one_of = 0;  ///< one of so many paths is logged; 0: none
    bool log_vertices = false;     ///< with their vertices
    /// Roulette by the power left goes on as if directions had been drawn without a guide: else it
    /// ends the photons that the guide had multiplied.
    bool unguided_roulette = false;
};

/// The numbers of a path of the plain sampler: the emission's are an Owen-scrambled Sobol'
/// sequence, those of the bounces a stream addressed by the photon.
class SequencePath {
  public:
    /// Starts paths of one pass, in a sequence that begins at path number `begin` of the render and
    /// shares nothing with those that begin elsewhere. One must begin wherever photons have decided
    /// where, or how many, the next ones go: points that keep away from those that decided, as a
    /// sequence's do, are not independent of the choice (a guide made the image brighter by 1 % at
    /// one path a pass; docs/understand/sharing-light.md).
    SequencePath(std::uint64_t seed, std::uint64_t pass, std::uint64_t begin)
        // Each 2^32 points are a net with a scramble of its own: that of the low half of `begin`.
        : SequencePath(seed, pass, (std::uint64_t{static_cast<std::uint32_t>(begin)} << 32) - begin,
                       begin ? hash_bits(static_cast<std::uint32_t>(begin >> 32) + 1) : 0) {}

    /// Goes to path number `serial` of the render, `index` of the pass. Cheapest in order.
    void move_to(std::uint64_t serial, std::uint32_t index) {
        emission_.move_to(serial + offset_);
        bounces_ = RandomStream(seed_, pass_, index, RandomDomain::Photon);
    }
    /// Where the light emits.
    PrimaryPoint start() const {
        return primary_point(
            {emission_.bits(0), emission_.bits(1), emission_.bits(2), emission_.bits(3)});
    }
    /// Chooses the light; in [0, 1).
    float light_choice() const { return emission_(kStartCoordinates); }
    RandomStream& bounce(std::uint32_t /*depth*/) { return bounces_; }

  private:
    SequencePath(std::uint64_t seed, std::uint64_t pass, std::uint64_t offset,
                 std::uint32_t scramble)
        : seed_(seed),
          pass_(pass),
          offset_(offset),
          emission_(scramble ^ static_cast<std::uint32_t>(seed * 0x9E3779B97F4A7C15ull >> 32)),
          bounces_(seed, pass, 0, RandomDomain::Photon) {}

    std::uint64_t seed_, pass_;
    std::uint64_t offset_;  // from a path's number to its point's, modulo 2^64
    SobolRun emission_;
    RandomStream bounces_;
};

/// Traces a path with the given numbers (SequencePath, or PrimaryPath of a Markov chain), `index`
/// of its pass, and appends its photons. Photons that shadow rays own
/// (docs/understand/who-carries-which-light.md) are dropped, or marked if input.store_owned. `log`
/// (may be null) takes the path's record, `collisions` (may be null only if no medium scatters)
/// what it leaves in media.
template <class Numbers>
void trace_photon_path(const PhotonInput& input, Numbers& numbers, std::uint32_t index,
                       InvalidSampleFilter& filter, Arena& arena, std::vector<Photon>& photons,
                       PhotonCounts& counts, PathLog* log = nullptr,
                       std::vector<VolumePhoton>* collisions = nullptr);

}  // namespace aips
