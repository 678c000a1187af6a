// From which visible points eye paths go on, and for which share of the light there.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "aips/core/base/constants.h"
#include "aips/core/tables/gloss_table.h"
#include "aips/core/tables/share_table.h"
#include "eye/constants.h"
#include "eye/point_gloss.h"

namespace aips {

/// Const while a pass is traced; whoever learns from passes changes it in between.
struct EyeShares {
    explicit EyeShares(const Bounds& scene) : table(scene) {}

    /// Whether eye path `path` of pass `pass` goes on even where it has no share, to tell what it
    /// would bring beside photons.
    bool explores(std::uint64_t pass, std::uint32_t path) const {
        // At first together as many as one pass has eye paths.
        const std::uint64_t stride = pass < kEarlyOneOf     ? kEarlyOneOf
                                     : pass < kWarmUpPasses ? kLateOneOf
                                                            : kLateExplorers;
        return shoots && is_one_of(stride, pass, path);
    }
    /// Whether it is one of so many eye paths of all passes, all of them in passes that shoot: one
    /// of fewer there. What is one of a multiple of `stride` is one of these too.
    bool is_one_of(std::uint64_t stride, std::uint64_t pass, std::uint32_t path) const {
        return (pass / turns + path) % std::max<std::uint64_t>(1, stride / turns) == 0;
    }
    /// Whether eye path `path` of pass `pass` is learned from: all early ones are, and all that
    /// explore.
    bool learns_from(std::uint64_t pass, std::uint32_t path) const {
        return pass < kWarmUpPasses || is_one_of(kLateOneOf, pass, path);
    }
    /// At a place on the side that `normal` shows.
    EyeShare at(Vec3 position, Vec3 normal) const {
        return any ? table.at(position, normal) : EyeShare{};
    }

    /// The same for photons on glossy lobes that bounce as well.
    GlossDensities gloss_at(Vec3 position, Vec3 normal) const {
        return {gloss && gloss->at(position, normal) ? kCausticDensity : 0, kIndirectDensity};
    }

    ShareTable table;
    std::optional<GlossTable> gloss;  ///< who brings caustics to glossy lobes, if any
    /// Whether there is light that photons alone bring to them: of a delta light, by way of
    /// specular surfaces.
    bool gloss_needs_photons = false;
    /// Passes before the present shares were set. Numbers that are stratified over passes start
    /// anew there: points that keep away from those that were learned from are not independent of
    /// what was learned.
    std::uint64_t passes_before = 0;

    std::uint32_t turns = 1;  ///< passes of which one shoots photons; a power of two
    bool shoots = true;       ///< whether the pass does

    bool any = false;  ///< whether a ray leaves some place, or may
};

/// Direct light of a visible point that a BSDF-sampled ray left: luminances. A shadow ray and the
/// path's BSDF-sampled ray share it, which is calmer than shadow rays alone.
///
/// Let a shadow ray ask light l with probability p_l. G_l is what l brings, S_l the part that the
/// shadow ray keeps, B_l = G_l - S_l that of the BSDF-sampled ray. Over many passes the choice of
/// l, which is stratified, comes evenly, and what is left is the variance for a given light. It
/// falls by
///
///     E[X^2] - E[S^2] - E[B^2] - (sum over l of (G_l^2 - S_l^2) / p_l) + (sum of B_l)^2,
///
/// X, S and B being samples: of the shadow ray alone, of what it keeps, and of the BSDF-sampled
/// ray. The first three terms are at least E[X (X - S)]. The others are products of expectations,
/// and a shadow ray and a BSDF-sampled ray from the same point are independent: B_l (G_l + S_l) /
/// p_l is the mean of what the BSDF-sampled ray brought of the light that was asked, times X + S,
/// over p_l.
///
/// Whole variances, with the choice of lights in them, would hardly tell: under sun and sky nearly
/// all of it is that choice, and sharing does not lessen it.
struct SharedDirect {
    float alone = 0;   ///< of the shadow ray if it shared nothing (X)
    float shadow = 0;  ///< of the shadow ray (S)
    float first = 0;   ///< of lights that the BSDF-sampled ray met (B)
    /// Of the light among them that the shadow ray asked, over the probability of asking it.
    float asked_again = 0;
    float end_pdf = 1;  ///< probability that the path ended at the point: only then B is added

    /// What sharing takes from the variance, and what it adds to it: squared luminances, whose
    /// expectations differ by what is saved. The second may be below zero.
    float taken() const { return alone * (alone - shadow); }
    float added() const {
        return end_pdf * (asked_again * (alone + shadow) - first * (alone - shadow));
    }
};

}  // namespace aips
