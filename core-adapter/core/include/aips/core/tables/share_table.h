// Which share of the light at a place continued eye paths carry, and which photons: a number `a` in
// each leaf of a ScoreCache, with the moments of both that it follows from.
//
// Two unbiased estimates of one value, independent given the place, are joined best in inverse
// proportion to their variances: a = V_photons / (V_photons + V_eye). With X what photons bring to
// a visible point and Y what an eye path that goes on from there brings, both with the light's
// expectation L, E[Y^2] - E[X Y] is the variance of Y averaged over a leaf however L changes
// within it, and needs no estimate of L. X's own variance is told by the squares of what single
// photons bring, or, where those are not independent, by E[X^2] - E[X Y].
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "aips/core/base/parallel.h"
#include "aips/core/tables/constants.h"
#include "aips/core/trees/score_cache.h"

namespace aips {

struct ShareTableSettings {
    ScoreCacheSettings places{.max_leaves = kTableLeaves,
                              .split_count = kShareSplitPoints,
                              .memory_paths = 1e15};  // nothing that is learned grows old
    double prior_count =
        kSharePrior;  ///< visible points that the mean over all leaves weighs in each, > 0
};

/// What eye paths do that end at a place.
struct EyeShare {
    float share = 0;           ///< of the light that both can carry, in [0, 1): above 0 they go on
    bool bsdf_direct = false;  ///< where it is 0: they send one ray, for direct light alone
    /// Least share of their light that photons lose in a gather disc which is not all surface, from
    /// which on eye paths bring what is lost; above 0.
    float fills_from = std::numeric_limits<float>::infinity();

    bool operator==(const EyeShare&) const = default;
    /// Whether a ray leaves the place.
    bool any() const { return share > 0 || bsdf_direct; }
    /// Whether eye paths bring what photons lose, where that is most of the light at least.
    bool may_fill() const { return fills_from < 1; }
};

/// What a visible point told of light that both can carry: luminances, as if nothing were shared.
struct ShareSample {
    Vec3 position;
    Vec3 normal;              ///< any length but 0
    double weight = 0;        ///< of a squared error there, >= 0
    double photons = 0;       ///< X
    double filled = 0;        ///< what the eye path brings as photons have lost it
    double photon_paths = 0;  ///< that X comes from
    double squares = 0;       ///< of what single photons brought to X, times photon paths
    double others = 0;        ///< the same of light that photons alone carry
    bool continued = false;   ///< whether an eye path went on: the rest is known only then
    double eye = 0;           ///< Y
    double rays = 0;          ///< traced for it
    /// By how much less the variance of direct light is where its BSDF-sampled ray shares it with
    /// shadow rays: an estimate, of either sign.
    double direct_saved = 0;
};

/// Sums over the samples of a leaf.
struct ShareMoments {
    double population = 0;  ///< how many visible points lie there; older ones fade, none is a prior
    double points = 0;      ///< that the sums below stand for
    double squares = 0, others = 0;  ///< weighed sums of ShareSample::squares, others
    double continued = 0;            ///< points of them from which eye paths went on
    double xx = 0, xy = 0, yy = 0;   ///< weighed sums over those
    double spread = 0;               ///< weighed sum of X (X - Y) times photon paths
    double x = 0, y = 0;             ///< sums over those, each times the root of its weight
    double rays = 0;
    double direct_saved = 0;  ///< weighed sum

    void add(const ShareMoments& other);
    void scale(double factor);
    void scale_points(double factor);     ///< what all points tell
    void scale_continued(double factor);  ///< what those tell from which eye paths went on
    void state(StateArchive& archive);
};

/// Learns between passes by add() and update(); at() changes at set_shares() and update() alone
/// and may be called from many threads in between. Deterministic: a function of the calls.
class ShareTable {
  public:
    /// Throws std::invalid_argument when a setting is out of range.
    explicit ShareTable(const Bounds& scene, const ShareTableSettings& settings = {});

    EyeShare at(Vec3 position, Vec3 normal) const {
        return shares_[places_.leaf_at(position, normal)];
    }

    /// [leaf]; valid until they change.
    std::span<const EyeShare> shares() const { return shares_; }

    /// Learns from a visible point; false, learning nothing, if a number is not usable.
    bool add(const ShareSample& sample);
    /// add() of all `samples` on the threads of `parallel`, the same for any: sums are taken group
    /// by group, and round as such.
    void add(std::span<const std::vector<ShareSample>> samples, const ParallelFor& parallel);
    /// After `samples` calls of add(): splits leaves. A new leaf has its parent's share.
    void update(std::size_t samples);

    /// [leaf]: what it met, joined by a prior of what all did.
    std::vector<ShareMoments> moments() const;
    /// What was met counts for `factor` of what will be.
    void forget(double factor);
    /// What was met counts for no more than so many visible points.
    void fade(double points);
    /// [leaf].
    void set_shares(std::span<const EyeShare> shares);

    /// Saves what was learned, or restores it into a new table of the same scene and settings. To
    /// be called after update(), with nothing added since.
    void state(StateArchive& archive);
    std::uint32_t leaf_count() const { return places_.leaf_count(); }
    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes(), from the settings alone.
    static std::size_t memory_bound_bytes(const ShareTableSettings& settings);

  private:
    /// In `places_`; none if a number is not usable.
    std::uint32_t branch_of(const ShareSample& sample) const;
    struct Group;
    Group group_of(std::span<const ShareSample> samples) const;
    void add_leaves();

    ShareTableSettings settings_;
    ScoreCache places_;
    ShareMoments everywhere_;
    std::vector<ShareMoments> leaves_;  // [leaf]
    std::vector<EyeShare> shares_;      // [leaf]
};

}  // namespace aips
