// Where photon paths come from: independent ones, or Markov chains.
#pragma once

#include <memory>
#include <span>

#include "aips/adapter/engine.h"
#include "estimate/gather_radii.h"
#include "estimate/pass_photons.h"
#include "photons/pass_guide.h"
#include "photons/photon_iteration.h"

namespace aips {

/// The photon paths of one iteration: `count` from number `first` of the pass.
struct IterationPaths {
    const PassPhotons& photons;
    std::uint32_t first = 0, count = 0;
};

/// Where photon paths leave what they leave.
struct PathTraces {
    PhotonStore& photons;
    PathLog* log = nullptr;                           ///< null: none are logged
    std::vector<VolumePhoton>* collisions = nullptr;  ///< null unless media scatter
};

class PhotonSource {
  public:
    virtual ~PhotonSource() = default;
    /// How far from a visible point photons are of use, scene units.
    virtual float reach(const GatherRadii& radii) const = 0;
    /// Where paths have to land to be of use, from the next pass until it is told anew.
    virtual void mark_reach(std::span<const Vec3> visible_points, float radius) = 0;
    virtual void begin_pass(const PassPhotons& photons) = 0;
    /// Photon paths of the next iteration, if no guide asks for others.
    virtual std::uint32_t iteration_paths() const = 0;
    /// Traces exactly so many paths. The result does not depend on the number of threads.
    virtual PhotonCounts trace(const PhotonInput& input, const IterationPaths& paths,
                               InvalidSampleFilter& filter, const PathTraces& traces) = 0;
    /// Ends the pass. Returns what its photons, summed, must be multiplied with to stand for as
    /// many independent photon paths as the pass has.
    virtual double end_pass() = 0;
    /// Between passes: saves what later ones go on from, or restores it.
    virtual void state(StateArchive& archive) = 0;
    virtual void add_to(EngineStatistics& statistics) const = 0;
    virtual std::size_t memory_bytes() const = 0;
};

/// Independent paths, or those of chains that search for visible ones by chance.
std::unique_ptr<PhotonSource> make_photon_source(bool chains);

}  // namespace aips
