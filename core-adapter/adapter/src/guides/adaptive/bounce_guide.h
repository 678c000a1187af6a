// guide=adaptive at the bounces: learned directions on surfaces that scatter diffusely.
//
// The table's product with Lambert's lobe is in its square; other lobes come in by the one-sample
// mixture alone. Light that passes through a surface is left to its Bsdf, as are specular lobes.
#pragma once

#include "aips/adapter/guide.h"
#include "aips/core/tables/bounce_tables.h"
#include "contribution/path_log.h"

namespace aips {

class BounceGuide final : public DirectionGuide {
  public:
    /// Scored photon paths count in full up to `memory_paths`; older ones fade.
    BounceGuide(const Bounds& scene, double memory_paths);

    const GuidedDirections* directions(const GuideVertex& vertex,
                                       std::pmr::memory_resource& memory) const override;
    /// Learns from a vertex, after which the path scored `score` at a cost of `cost` rays.
    void add(const PathVertex& vertex, double score, double cost);
    /// After `paths` further scored photon paths.
    void update(double paths) { tables_.update(paths); }

    /// Between passes: saves what was learned, or restores it into a new guide.
    void state(StateArchive& archive) { tables_.state(archive); }

    /// As that of BounceTables.
    void fade(double paths) { tables_.fade(paths); }

    const BounceTables& tables() const { return tables_; }
    std::size_t memory_bytes() const { return tables_.memory_bytes(); }
    static std::size_t memory_bound_bytes(double memory_paths);

  private:
    BounceTables tables_;
};

}  // namespace aips
