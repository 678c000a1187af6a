// Next-event estimation at eye vertices, and the densities that weigh it against bounces.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aips/adapter/scene.h"
#include "aips/core/sampling/eye_numbers.h"
#include "aips/core/tables/discrete_distribution.h"
#include "aips/core/tables/learned_lights.h"
#include "sample_filter/invalid_sample_filter.h"
#include "views/light_target.h"

namespace aips {

/// The eye vertex at which direct light is estimated.
struct DirectLightQuery {
    const SurfacePoint& point;
    Vec3 wo;
    float time = 0;
    Rgb throughput;  ///< of the eye path up to here
    /// Lobes whose direct light belongs to shadow rays alone, or also to the path's next ray, which
    /// is drawn from them with probability `owned_pdf` (balance heuristic).
    LobeMask owned = 0;
    float owned_pdf = 0;
    LobeMask shared = 0;     ///< lobes whose bounce can also meet the light (balance heuristic)
    LobeMask bounce = 0;     ///< the mask that the bounce samples: `shared` and specular lobes
    float continue_pdf = 0;  ///< probability that the eye path bounces
};

/// What an estimate did.
struct DirectLightResult {
    unsigned rays = 0;   ///< shadow rays traced
    float alone = 0;     ///< luminance that they would bring if nothing were shared of `owned`
    float brought = 0;   ///< luminance that was added
    LightSample sample;  ///< what was learned; its pdf is 0 if that is nothing
};

/// Chooses a light, by power or by what it was seen to bring, and samples one direction towards it.
class DirectLight {
  public:
    /// `learns`: the choice follows what learn() is told.
    DirectLight(const Scene& scene, bool learns);

    /// Adds the estimate to `radiance`.
    DirectLightResult estimate(const DirectLightQuery& query, const VertexNumbers& numbers,
                               InvalidSampleFilter& filter, const LightTarget& radiance) const;

    /// Density per steradian with which `estimate` would have drawn the light met by the direction
    /// wi from `from`; `at` is the point met, null for lights at infinity.
    float pdf(LightIndex light, const SurfacePoint& from, Vec3 wi, const SurfacePoint* at) const;

    /// Probabilities of the lights to be chosen without knowing where.
    const DiscreteDistribution& choice() const { return choice_; }

    /// Those at a place; `normal` of any length but 0.
    const DiscreteDistribution& choice_at(Vec3 position, Vec3 normal) const {
        // A single light is chosen everywhere, whatever is learned.
        return learned() ? learned_->at(position, normal) : choice_;
    }
    /// Whether choices differ from place to place.
    bool learned() const { return learned_.has_value() && choice_.size() > 1; }

    /// Whether there is more to learn.
    bool learns() const { return learned_ && learned_->learns(); }
    /// Whether anything was learned.
    bool knows() const { return learned_ && learned_->knows(); }
    /// As LearnedLights::learn(); without need to learn nothing is done.
    void learn(std::span<const LightSample> samples, std::uint64_t due, std::uint64_t passes) {
        if (learned_) learned_->learn(samples, due, passes);
    }
    /// Passes before the present choices were made (LearnedLights::passes_before()).
    std::uint64_t passes_before() const { return learned_ ? learned_->passes_before() : 0; }
    /// Saves or restores what was learned.
    void state(StateArchive& archive) {
        if (learned_) learned_->state(archive);
    }
    /// As LearnedLights::learned().
    void learned(LearnedParts& parts) {
        if (learned_) learned_->learned(parts);
    }
    /// Memory held for learning.
    std::size_t memory_bytes() const { return learned_ ? learned_->memory_bytes() : 0; }
    /// Upper bound of memory_bytes() if it learns, from at most `samples` shadow rays a pass.
    static std::size_t memory_bound_bytes(const Scene& scene, std::size_t samples);

    /// Lights that rays which leave the scene may see, in the scene's order.
    std::span<const LightIndex> at_infinity() const { return at_infinity_; }

  private:
    const DiscreteDistribution& choice_at(const SurfacePoint& point) const {
        return choice_at(point.position, point.geometric_normal);
    }

    const Scene& scene_;
    DiscreteDistribution choice_;
    std::optional<LearnedLights> learned_;
    std::vector<LightIndex> at_infinity_;
};

}  // namespace aips
