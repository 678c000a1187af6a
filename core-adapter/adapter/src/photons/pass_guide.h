// What a guide has to do with a photon pass: it sees the pass begin, tells iterations where to send
// their photons, and learns from what they left: at once, or while the next iteration is traced.
#pragma once

#include <memory>
#include <span>

#include "aips/adapter/engine.h"
#include "aips/core/base/learned_parts.h"
#include "contribution/pixel_importance.h"
#include "estimate/gather_radii.h"
#include "photons/photon_iteration.h"

namespace aips {

class AdaptiveGuide;
struct EmissionSeed;

/// A pass that begins; all of it stays until the pass ends.
struct GuidedPass {
    std::uint64_t number = 0;
    float time = 0;
    const EyeImage& image;
    std::span<const Vec3> positions;  ///< of the visible points
    const GatherRadii& radii;
};

/// Without a guide: photons go by the lights' power and the materials.
class PassGuide {
  public:
    virtual ~PassGuide() = default;
    /// Whether begin_pass() wants to know where the visible points of each pass are.
    virtual bool wants_points() const { return false; }
    /// Before the first pass: starts of photon paths that are seen, those of one light in
    /// succession.
    virtual void begin_with(std::span<const EmissionSeed> /*starts*/) {}
    /// Returns the rays that it traced.
    virtual std::uint64_t begin_pass(const GuidedPass& /*pass*/) { return 0; }
    /// Says in `input`, which is that of an unguided pass, what the iteration's photons follow.
    virtual void guide(std::uint64_t /*iteration*/, PhotonInput& /*input*/) {}
    /// Photon paths of an iteration where none would be cut shorter for the guide.
    virtual std::uint32_t iteration_paths(std::uint64_t /*iteration*/,
                                          std::uint32_t unguided) const {
        return unguided;
    }
    /// Where the photons of an iteration go; `waiting` are those to be gathered.
    virtual PhotonStore& photons(PhotonStore& waiting) { return waiting; }
    /// Where the iteration's paths are recorded; null: nowhere.
    virtual PathLog* log() { return nullptr; }
    /// Whether study() has something to learn from.
    virtual bool has_studies() const { return false; }
    /// Learns from what the last iteration recorded. Changes nothing that photons follow, so that
    /// the next one may be traced at the same time.
    virtual void study() {}
    /// After an iteration of `paths` photon paths, before what they carried is weighted: what was
    /// studied while it was traced decides from here on, and what it recorded is studied next. A
    /// guide that doesn't study learns from it here; those of its own photons that are near
    /// visible points go on to `waiting`. Returns how many paths, vertices and photons it learned
    /// from, if that costs time of its own.
    virtual std::uint64_t learn(std::uint32_t /*paths*/, const OccupancyGrid& /*near*/,
                                PhotonStore& /*waiting*/) {
        return 0;
    }
    /// After the last iteration of a pass, when that has been studied: nothing is left to learn.
    virtual std::uint64_t end_pass() { return 0; }
    /// What photon path number `path`, PassPhotons::known of earlier renders counted in, counts for
    /// in the image, in (0, 1]: fixed in advance.
    virtual double weight(std::uint64_t /*path*/) const { return 1; }
    /// Between passes: saves what was learned, or restores it into a new guide.
    virtual void state(StateArchive& /*archive*/) {}
    /// The same for another render, from before the first pass on.
    virtual void learned(LearnedParts& /*parts*/) {}
    virtual void add_to(EngineStatistics& /*statistics*/) const {}
    virtual std::size_t memory_bytes() const { return 0; }
    /// Bounces of the last pass by the guide's node, for debug layers; may be null.
    virtual const BounceStatistics* bounces() const { return nullptr; }
    /// For the log, which tells what of it is disabled; null for others.
    virtual const AdaptiveGuide* adaptive() const { return nullptr; }
};

/// `light_choice` (by power) and `importance` outlive it.
std::unique_ptr<PassGuide> make_adaptive_pass_guide(const Scene& scene, const Settings& settings,
                                                    const DiscreteDistribution& light_choice,
                                                    const PixelImportance& importance);

/// `guide` and `importance`, which may be null unless the guide needs scores, outlive it.
std::unique_ptr<PassGuide> make_paper_pass_guide(Guide& guide, const Settings& settings,
                                                 const PixelImportance* importance);

}  // namespace aips
