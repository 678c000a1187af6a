// Next-event estimation at eye vertices, and the densities that weigh it against bounces.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aips/adapter/scene.h"
#include "aips/core/sampling/eye_numbers.h"
#include "aips/core/tables/discrete_distribution.h"
#include "aips/core/tables/light_tables.h"
#include "refusal/refusals.h"

namespace aips {

/// The eye vertex at which direct light is estimated.
struct DirectLightQuery {
    const SurfacePoint& point;
    Vec3 wo;
    float time = 0;
    Rgb throughput;          ///< of the eye path up to here
    LobeMask owned = 0;      ///< lobes whose direct light belongs to shadow rays alone
    LobeMask shared = 0;     ///< lobes whose bounce can also meet the light (balance heuristic)
    LobeMask bounce = 0;     ///< the mask that the bounce samples: `shared` and specular lobes
    float continue_pdf = 0;  ///< probability that the eye path bounces
};

/// What an estimate did.
struct DirectLightResult {
    unsigned rays = 0;   ///< shadow rays traced
    LightSample sample;  ///< what was learned; its pdf is 0 if that is nothing
};

/// Chooses a light, by power or by what it was seen to bring, and samples one direction towards it.
class DirectLight {
  public:
    /// `learns`: the choice follows what learn() is told.
    DirectLight(const Scene& scene, bool learns);

    /// Adds the estimate to `radiance`, one entry a light group.
    DirectLightResult estimate(const DirectLightQuery& query, const VertexNumbers& numbers,
                               Refusals& refusals, std::span<Rgb> radiance) const;

    /// Density per steradian with which `estimate` would have drawn the light met by the direction
    /// wi from `from`; `at` is the point met, null for lights at infinity.
    float pdf(LightIndex light, const SurfacePoint& from, Vec3 wi, const SurfacePoint* at) const;

    /// Probabilities of the lights to be chosen without knowing where.
    const DiscreteDistribution& choice() const { return choice_; }

    /// Whether there is more to learn.
    bool learns() const;
    /// After `passes` passes: what shadow rays told, in an order that does not depend on threads.
    /// `due`: eye paths that were to tell, found by their numbers; at least as many as did. Choices
    /// are made anew after a number of those: the number that did depends on the numbers they drew.
    void learn(std::span<const LightSample> samples, std::uint64_t due, std::uint64_t passes);
    /// Passes before the present choices were made. Numbers that are stratified over passes start
    /// anew there: points that keep away from those that were learned from are not independent of
    /// the choices.
    std::uint64_t passes_before() const { return passes_before_; }
    /// Saves or restores what was learned.
    void state(StateArchive& archive);
    /// Memory held for learning.
    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes() if it learns, from at most `samples` shadow rays a pass.
    static std::size_t memory_bound_bytes(const Scene& scene, std::size_t samples);

    /// Lights that rays which leave the scene may see, in the scene's order.
    std::span<const LightIndex> at_infinity() const { return at_infinity_; }

  private:
    const DiscreteDistribution& choice_at(const SurfacePoint& point) const {
        // A single light is chosen everywhere, whatever is learned.
        const bool varies = tables_ && choice_.size() > 1;
        return varies ? tables_->at(point.position, point.geometric_normal) : choice_;
    }

    std::uint64_t due_at_most() const;

    const Scene& scene_;
    DiscreteDistribution choice_;
    std::optional<LightTables> tables_;
    std::vector<LightSample> waiting_;  ///< not learned yet: tables are made anew now and then
    std::uint64_t due_ = 0;             ///< since choices were made, and all before that
    std::uint64_t learned_ = 0;
    std::uint64_t passes_before_ = 0;
    std::vector<LightIndex> at_infinity_;
};

}  // namespace aips
