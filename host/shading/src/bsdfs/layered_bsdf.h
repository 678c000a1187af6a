// Up to four surfaces on top of each other, with all light that goes back and forth between them.
// Sources: Guo, Hasan and Zhao 2018, "Position-free Monte Carlo simulation for arbitrary layered
// BSDFs" (the estimator); Veach 1997, section 5.3 (its adjoint half).
#pragma once

#include <array>

#include "lxs/sdk/bsdf.h"
#include "lxs/sdk/hashed_numbers.h"

namespace lxs::shading {

/// Share of light that gets from one layer to the next.
float between_layers(float thickness, float cosine);

/// The value of a stack has no closed form. It is estimated by two random walks, one from each
/// direction, that are joined; their numbers are hashed from the two directions and the place, so
/// that asking twice gives the same answer, whose mean over neighbouring questions is the exact
/// value. Directions are drawn from a density that is known exactly (the layers' own, and a
/// cosine), so that weights are exact quotients and strategies combine as with any other Bsdf.
///
/// What the layer that is met first reflects at once has no noise and keeps its kind of lobe; all
/// the rest is one lobe, diffuse if any layer is. Chains of deltas only are a specular lobe.
class LayeredBsdf final : public Bsdf {
  public:
    static constexpr int kMaxLayers = 4;

    /// Layers from the front (+ng) to the back; null: absorbs everything.
    struct Stack {
        std::array<const Bsdf*, kMaxLayers> layers{};
        int count = 0;
        bool transmits = false;  ///< light may get through all of them
        float thickness = 0;     ///< exp(-thickness / cosine) of the light gets to the next layer
    };
    /// `place` tells points apart.
    LayeredBsdf(const Stack& stack, const Vec3& place, const Vec3& ng, const Vec3& ns);

    LobeMask lobes() const override { return lobes_; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    /// Probabilities of the ways to draw a direction: a chain of deltas, one of the layers' own
    /// densities, a cosine.
    struct Choice {
        float specular = 0;
        std::array<float, kMaxLayers> layer{};
        float cosine = 0;
    };
    struct Walk;

    int entry(const Vec3& w) const { return w.dot(ng_) > 0 ? 0 : stack_.count - 1; }
    /// Lobes of layer `i` in `mask` that its density is taken of.
    LobeMask drawn_lobes(int i, const Vec3& wo, LobeMask mask) const;
    Choice choose(const Vec3& wo, LobeMask mask) const;
    float density(const Choice& choice, const Vec3& wo, const Vec3& wi, LobeMask mask) const;
    float cosine_density(const Vec3& wo, const Vec3& wi) const;
    bool sample_cosine_lobe(const Vec3& wo, const Vec2& u, float u_side, Vec3& wi) const;
    /// Draws wi by the non-specular part of `choice`.
    bool draw(const Choice& choice, const Vec3& wo, const Vec2& u, float u_lobe, LobeMask mask,
              BsdfSample& sample) const;
    bool sample_specular(const Vec3& wo, HashedNumbers numbers, Transport transport,
                         BsdfSample& sample) const;
    /// One event at the walk's layer; false where light is absorbed.
    bool advance(Walk& walk, HashedNumbers& numbers, Transport transport, LobeMask mask) const;
    /// Steps of a walk that starts along `w`, until it leaves the stack or is absorbed.
    int trace(const Vec3& w, HashedNumbers& numbers, Transport transport, bool backwards,
              Walk* steps) const;
    /// Everything but the entry layer's own reflection.
    Rgb estimate_rest(const Vec3& wo, const Vec3& wi, Transport transport) const;
    Rgb joined(const Walk& a, const Walk& b, Transport transport) const;

    Stack stack_;
    Vec3 place_, ng_, ns_;
    LobeMask lobes_ = 0;
    LobeMask rest_ = 0;  ///< kind of the estimated lobe; 0 if there is none
};

}  // namespace lxs::shading
