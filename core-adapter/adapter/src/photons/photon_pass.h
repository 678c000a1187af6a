// The photon pass: iterations of photon paths, guide updates between them, gathers when the
// landings fill their store.
#pragma once

#include <memory>
#include <optional>

#include "aips/adapter/engine.h"
#include "estimate/gather.h"
#include "estimate/pass_photons.h"
#include "guides/adaptive/adaptive_guide.h"
#include "media/volume_gather.h"
#include "photons/photon_chains.h"
#include "worth/iteration_scores.h"

namespace aips {

/// Seconds and counts of photon passes so far.
struct PhotonPassTotals {
    PhotonCounts counts;
    std::uint64_t gathered = 0;
    std::uint64_t learned = 0;  ///< paths, vertices and landings that guide=adaptive learned from
    double photon_seconds = 0, gather_seconds = 0, guide_seconds = 0;
};

/// Landings that wait for a gather; one iteration may exceed it.
inline constexpr std::uint32_t kLandingCapacity = 1u << 20;

/// Shoots the photons of one pass onto the visible points of an eye image.
class PhotonPass {
  public:
    /// `guide` may be null, `importance` too unless a guide needs scores; they outlive this.
    PhotonPass(const Scene& scene, const Settings& settings, Guide* guide,
               const PixelImportance* importance);

    /// Shoots `photons` and fills `flux` for the visible points in `image`. In modes that freeze
    /// the eye pass the visible points must be the same in each pass.
    void shoot(std::uint64_t pass, const PassPhotons& photons, float time, const EyeImage& image,
               const SearchRadii& radii, Refusals& refusals, PhotonFlux& flux);

    const PhotonPassTotals& totals() const { return totals_; }
    /// Fills `radiance` with what the photons of the pass brought to each eye path, by light group,
    /// on surfaces (`flux`) and in media, and `variances`, unless null, with those of its
    /// luminance.
    void estimate(const EyeImage& image, const PhotonFlux& flux, const SearchRadii& radii,
                  std::uint64_t photon_paths, Refusals& refusals, std::vector<Rgb>& radiance,
                  std::vector<float>* variances) const;

    /// Before the first pass: photons go without the adaptive guide, for good, independent ones or
    /// (may_use_chains) from Markov chains.
    void leave_out_guide(bool for_chains) {
        adaptive_.reset();
        chained_ = for_chains;
    }

    /// Between passes: saves what later ones go on from, or restores it into a new one; the guide
    /// and the importance are saved by themselves, and seconds by state_of_seconds().
    void state(StateArchive& archive);
    void state_of_seconds(StateArchive& archive);

    /// Null unless photon paths come from chains.
    const PhotonChains* chains() const { return chained_ ? &*chains_ : nullptr; }
    /// Null unless guide=adaptive, and not left out.
    const AdaptiveGuide* adaptive() const { return adaptive_ ? &*adaptive_ : nullptr; }
    /// Bounces of the last pass by the guide's node; null without a guide or debug layers.
    const BounceTally* bounces() const { return bounces_ ? &*bounces_ : nullptr; }
    std::size_t memory_bytes() const;

  private:
    void begin_pass(std::uint64_t pass, const PassPhotons& photons, float time,
                    const EyeImage& image, const SearchRadii& radii);
    PhotonInput input_of(std::uint64_t pass, float time, std::uint64_t iteration);
    /// Where the sequence begins that the emissions of an iteration belong to.
    std::uint64_t sequence_begin(const PassPhotons& photons, std::uint32_t first,
                                 bool guided) const {
        // A guide follows what the iteration before brought, and it rests or not by that too.
        return guided ? photons.before + first : std::max(photons.chosen_at, unguided_from_);
    }
    void mark_reach(std::span<const Vec3> visible_points, float radius);
    std::uint32_t iteration_paths(std::uint64_t iteration) const;
    void trace(const PhotonInput& input, const PassPhotons& photons, std::uint32_t first,
               std::uint32_t count, Refusals& refusals);
    void learn(std::uint32_t paths);
    void gather_in_media(const EyeImage& image, Refusals& refusals);
    void gather(const EyeImage& image, const SearchRadii& radii, Refusals& refusals,
                PhotonFlux& flux);

    const Scene& scene_;
    const Settings& settings_;
    Guide* guide_;
    DiscreteDistribution light_choice_;
    std::vector<Vec3> positions_;  // of the visible points, if something asks for them
    OccupancyGrid occupancy_;
    float reach_ = 0;  // radius that the visible points are marked for; 0 before the first pass
    std::optional<PhotonChains> chains_;  // if some pass may use them
    bool chained_ = false;                // they all do
    std::uint64_t unguided_from_ = 0;     // number of the path after the last of guided emission
    std::optional<AdaptiveGuide> adaptive_;
    PhotonTracer tracer_;
    PathLog log_;                            // of one adaptive iteration
    LandingStore waiting_;                   // near visible points, not gathered yet
    LandingStore iteration_;                 // all landings of one guided iteration
    std::optional<IterationScores> scores_;  // if guide_ learns from their scores
    LandingGrid grid_;
    std::optional<VolumeGather> volume_;  // if some medium scatters
    std::optional<BounceTally> bounces_;  // debug layers of a guide only
    PhotonPassTotals totals_;
};

}  // namespace aips
