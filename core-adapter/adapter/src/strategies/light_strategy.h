// A way of carrying light to the eye paths beside what they find by themselves. The pass loop knows
// nothing of any: a new one is a class behind this interface, and a line in make_strategies().
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "aips/adapter/engine.h"
#include "eye/eye_pass.h"
#include "plan/plan.h"

namespace aips {

/// A pass that is about to be traced.
struct ComingPass {
    std::uint64_t number = 0;
    float time = 0;
    const EyePassInput& eye;  ///< what its eye paths will be traced with
    InvalidSampleFilter& filter;
};

/// A pass whose eye paths are traced.
struct StrategyPass {
    std::uint64_t number = 0;
    float time = 0;
    const EyeImage& image;
    std::uint32_t eye_paths = 0;  ///< traced for this pass; 0 where earlier ones are kept
    std::uint64_t eye_rays = 0;   ///< of these, and those that strategies took before them
    InvalidSampleFilter& filter;
};

/// Which of the film's two means over passes light belongs to.
enum class PassMean : std::uint8_t {
    Alike,    ///< all passes count alike, as what eye paths see by themselves
    Weighted  ///< by a weight that was fixed before the pass; one strategy at most
};

/// What a strategy brings to the eye paths of a pass.
struct CarriedLight {
    /// [eye path * groups + group]; held by the strategy until its next pass. Empty: no light, in
    /// any pass.
    std::span<const Rgb> radiance = {};
    PassMean mean = PassMean::Alike;
    double weight = 1;  ///< of the pass in the mean, > 0; 1 for Alike
    /// Held likewise; in all passes or in none, by one strategy at most. All passes count alike.
    std::optional<FilmSplats> splats = {};
    /// Parts of `radiance`, if the film wants them: [eye path * kImageParts + ImagePart]; held
    /// likewise.
    std::span<const Rgb> parts = {};
};

class LightStrategy {
  public:
    virtual ~LightStrategy() = default;
    /// From which visible points eye paths go on, for light that the strategy shares with them;
    /// null: from none. At most one strategy has such. Stays as long as the strategy does.
    virtual const EyeShares* eye_shares() const { return nullptr; }
    /// Where its photons lose light at the edges of surfaces; null: nowhere. As above.
    virtual const DiscGaps* disc_gaps() const { return nullptr; }
    /// Images of emitters that the strategy draws paths through; null: none. As above.
    virtual const EmitterImages* emitter_images() const { return nullptr; }
    /// Before the eye paths of each pass are traced; returns the rays that it took beside theirs.
    virtual std::uint64_t begin_pass(const ComingPass& /*pass*/) { return 0; }
    /// Carries the light of one pass; adds what it did to `report`.
    virtual CarriedLight carry(const StrategyPass& pass, PassReport& report) = 0;
    /// The film has the pass: learns from it, for later ones.
    virtual void end_pass(const StrategyPass& pass, const FilmPass& film_pass) = 0;
    /// Between passes: saves what later ones go on from, or restores it into a new strategy;
    /// `image` is that of the last pass, or when restoring the one that is kept.
    virtual void state(StateArchive& archive, const EyeImage& image) = 0;
    /// The same of its times, which are no function of scene, settings and passes.
    virtual void state_of_seconds(StateArchive& archive) = 0;
    /// Saves what was learned for another render, or takes it into a new strategy before the first
    /// pass: of a scene that may have moved, so that it fades and nothing of it is final.
    virtual void learned(LearnedParts& /*parts*/) {}
    /// Adds its own counts and times.
    virtual void add_to(EngineStatistics& statistics) const = 0;
    /// Held now; at most memory_bound_bytes().
    virtual std::size_t memory_bytes() const = 0;
    virtual std::size_t memory_bound_bytes() const = 0;
};

using LightStrategies = std::vector<std::unique_ptr<LightStrategy>>;

/// The strategies that a plan asks for. The host's parts and the plan outlive them; `plan` is where
/// they write what they decide while the render goes on. `eye_paths`: of a pass.
LightStrategies make_strategies(const Host& host, Plan& plan, std::uint32_t eye_paths);

}  // namespace aips
