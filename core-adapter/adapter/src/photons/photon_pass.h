// The photon pass: iterations of photon paths, guide updates between them, gathers when the
// photons fill their store.
#pragma once

#include <memory>
#include <optional>

#include "aips/adapter/engine.h"
#include "base/luminance_by_light.h"
#include "contribution/pass_noise.h"
#include "estimate/gather.h"
#include "estimate/pass_photons.h"
#include "media/volume_gather.h"
#include "photons/pass_guide.h"
#include "photons/photon_source.h"

namespace aips {

/// Seconds and counts of photon passes so far.
struct PhotonPassTotals {
    PhotonCounts counts;
    std::uint64_t gathered = 0, gathered_in_media = 0;
    std::uint64_t beam_rays = 0;  ///< traced across beams
    LuminanceByLight light;       ///< luminance that photons brought, by light: summed over passes
    double weights = 0;           ///< of these passes
    std::uint64_t learned = 0;    ///< paths, vertices and photons that guide=adaptive learned from
    double photon_seconds = 0, gather_seconds = 0, guide_seconds = 0;
};

/// Shoots the photons of one pass onto the visible points of an eye image.
class PhotonPass {
  public:
    /// `light_choice`: by power; it outlives this.
    PhotonPass(const Scene& scene, const Settings& settings,
               const DiscreteDistribution& light_choice, std::unique_ptr<PassGuide> guide,
               std::unique_ptr<PhotonSource> source);

    /// Before the first pass, or one that is restored: another guide, for good.
    void take(std::unique_ptr<PassGuide> guide) { guide_ = std::move(guide); }
    /// Before the first pass: where photon paths start that are seen, as PassGuide takes it.
    void begin_with(std::span<const EmissionSeed> starts) { guide_->begin_with(starts); }

    /// Shoots `photons` and fills `flux` for the visible points in `image`. In modes that freeze
    /// the eye pass the visible points must be the same in each pass. `occlusion` as for
    /// gather_photons().
    void shoot(std::uint64_t pass, const PassPhotons& photons, float time, const EyeImage& image,
               const GatherRadii& radii, InvalidSampleFilter& filter, PhotonFlux& flux,
               PhotonOcclusion* occlusion = nullptr);

    /// What the photons of the pass brought to the image by light, if the settings ask for it;
    /// they were shot for so many `passes`. `brightened`: by what factor its flux as a whole was
    /// corrected after shoot().
    void count_transport(const PassPhotons& photons, std::uint32_t passes, const EyeImage& image,
                         double brightened);

    /// Fills `radiance` with what the photons of the pass brought to each eye path, by light group,
    /// on surfaces (`flux`) and in media, and `variances`, unless null, with those of its
    /// luminance.
    void estimate(const EyeImage& image, const PhotonFlux& flux, const GatherRadii& radii,
                  std::uint64_t photon_paths, InvalidSampleFilter& filter,
                  std::vector<Rgb>& radiance, PhotonVariances* variances) const;
    /// Fills `discs` with what whole gather discs and their inner halves brought, on surfaces and
    /// in media.
    void estimate_discs(const EyeImage& image, const PhotonFlux& flux, const GatherRadii& radii,
                        std::uint64_t photon_paths, DiscEstimates& discs) const;
    /// Fills `parts` with the parts of `radiance`, to which continued eye paths may have added.
    void estimate_parts(const EyeImage& image, const PhotonFlux& flux, const GatherRadii& radii,
                        std::uint64_t photon_paths, std::span<const Rgb> radiance,
                        std::vector<Rgb>& parts) const;

    /// Between passes: saves what later ones go on from, or restores it into a new one; the
    /// importance of pixels is saved by itself, and seconds by state_of_seconds().
    void state(StateArchive& archive);
    void state_of_seconds(StateArchive& archive);
    /// Saves what was learned for another render, or takes it before the first pass.
    void learned(LearnedParts& parts);

    const PhotonPassTotals& totals() const { return totals_; }
    const PassGuide& guide() const { return *guide_; }
    void add_to(EngineStatistics& statistics) const;
    std::size_t memory_bytes() const;

  private:
    void begin_pass(std::uint64_t pass, const PassPhotons& photons, float time,
                    const EyeImage& image, const GatherRadii& radii, VolumeWants wants);
    PhotonInput input_of(std::uint64_t pass, float time, std::uint64_t iteration);
    /// Where the sequence begins that the emissions of an iteration belong to.
    std::uint64_t sequence_begin(const PassPhotons& photons, std::uint32_t first,
                                 bool guided) const {
        // A guide follows what the iteration before brought, and it is disabled or not by that too.
        return guided ? photons.before + first : std::max(photons.chosen_at, unguided_from_);
    }
    void mark_reach(float radius);
    /// Traces an iteration while the guide learns from the one before, and weights what it carried.
    void run_iteration(PhotonInput& input, const IterationPaths& paths,
                       InvalidSampleFilter& filter);
    /// Beside the guide's studies, of which there may be none.
    template <class Work>
    void study_beside(Ranks* ranks, const Work& work);
    /// The last gather, beside the guide's studies of the last iteration.
    void end_iterations(const EyeImage& image, const GatherRadii& radii,
                        InvalidSampleFilter& filter, PhotonFlux& flux, PhotonOcclusion* occlusion);
    void gather_in_media(const EyeImage& image, InvalidSampleFilter& filter);
    void gather(const EyeImage& image, const GatherRadii& radii, InvalidSampleFilter& filter,
                PhotonFlux& flux, PhotonOcclusion* occlusion);
    /// What it shot stands for as many paths as it counts.
    /// Returns by what it scales the flux.
    double scale_to_counted(const PassPhotons& photons, PhotonFlux& flux);

    const Scene& scene_;
    const Settings& settings_;
    const DiscreteDistribution& light_choice_;
    std::unique_ptr<PassGuide> guide_;
    std::unique_ptr<PhotonSource> source_;
    std::vector<Vec3> positions_;  // of the visible points, if something asks for them
    OccupancyGrid occupancy_;
    float reach_ = 0;  // radius that the visible points are marked for; 0 before the first pass
    std::uint64_t unguided_from_ = 0;  // number of the path after the last of guided emission
    PhotonStore waiting_;              // near visible points, not gathered yet
    PhotonGrid grid_;
    double flux_factor_ = 1;              // of this pass's flux, beside that of single photons
    LuminanceByLight pass_light_;         // of this pass: luminance by light, times photon paths
    std::optional<VolumeGather> volume_;  // if some medium scatters
    PhotonPassTotals totals_;
};

}  // namespace aips
