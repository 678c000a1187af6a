// What decides where photon paths go. guide=none has no Guide at all.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <span>

#include "aips/adapter/bsdf.h"
#include "aips/core/base/state_archive.h"
#include "aips/core/photon_map/photon.h"

namespace aips {

/// Where a photon is about to scatter through a non-specular lobe.
struct GuideVertex {
    Vec3 position;
    Vec3 shading_normal;
    Vec3 wo;           ///< unit, back to where the photon came from
    const Bsdf* bsdf;  ///< never null
    Vec3 normal;       ///< unit geometric normal, on the side of wo
};

/// A guided density of directions at one vertex. Lives in dropped memory: trivially destructible.
class GuidedDirections {
  public:
    /// Share of directions to draw from this density, in [0, 1); the others come from the Bsdf.
    float share() const { return share_; }
    /// Draws a unit direction from u in [0,1)^2; its density is `pdf`.
    virtual Vec3 sample(Vec2 u) const = 0;
    /// Density per steradian; integrates to 1 over the sphere.
    virtual float pdf(Vec3 direction) const = 0;

  protected:
    explicit GuidedDirections(float share) : share_(share) {}
    ~GuidedDirections() = default;

  private:
    float share_;
};

/// What tells where photons ought to go on to: const and usable from many threads.
class DirectionGuide {
  public:
    virtual ~DirectionGuide() = default;
    /// The density to mix with the Bsdf at a vertex; null where the guide knows nothing.
    virtual const GuidedDirections* directions(const GuideVertex& vertex,
                                               std::pmr::memory_resource& memory) const = 0;
};

/// Counts of a guide, for logs, tests and the statistics file.
struct GuideStatistics {
    std::size_t nodes = 0;
    std::size_t memory_bytes = 0;
    std::uint64_t updates = 0;
};

/// What a guide knows of one node, for debug views.
struct GuideNode {
    double weight = 0;         ///< w of eq. 7, summed over passes
    double error = 0;          ///< feature error: finite, >= 0
    std::uint32_t parent = 0;  ///< node that it split from: a lower number, or 0 for node 0
};

/// Learns between iterations, and is frozen (const, usable from many threads) within them.
class Guide : public DirectionGuide {
  public:
    /// A new pass with these visible points begins (weights, eq. 7).
    virtual void begin_pass(std::span<const Vec3> visible_points, std::uint64_t eye_paths) = 0;
    /// Photon paths of iteration number `iteration` of this pass.
    virtual std::uint32_t iteration_paths(std::uint64_t iteration) const = 0;
    /// Whether that iteration follows the guide; the first of a pass does not.
    virtual bool guides(std::uint64_t iteration) const = 0;
    /// Whether update() wants photons that shadow rays own too.
    virtual bool learns_from_owned() const = 0;
    /// Whether update() wants the photons' scores.
    virtual bool needs_scores() const = 0;
    /// Learns from an iteration's photons, in their order; `scores` (PhotonScore), one for each,
    /// are empty unless needs_scores().
    virtual void update(std::span<const Photon> photons, std::span<const double> scores) = 0;
    virtual GuideStatistics statistics() const = 0;
    /// Number of the node at a position, below statistics().nodes; nodes are numbered in the order
    /// in which they split off, and keep their numbers.
    virtual std::uint32_t node_at(Vec3 position) const = 0;
    virtual GuideNode node(std::uint32_t number) const = 0;
    /// Between passes: saves what was learned, or restores it into a new guide.
    virtual void state(StateArchive& archive) = 0;
};

}  // namespace aips
