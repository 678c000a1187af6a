// A learned density over a light's primary coordinates: the emission guide of one light.
//
// A kd-tree over [0,1)^4 whose leaves hold the mean of |f|, f being the part in the image of what
// starts there (|f| / p is the root of a photon's score), and of what a photon costs. The density
// that minimises variance times cost is proportional to |f| / sqrt(cost); `sharpness` flattens it.
// Second moments in the leaves would be the exact measure, but scores have heavy tails, and the
// root's mean is known long before the square's (docs/understand/adaptive-guide.md).
// Sources: Lepage 1978 (VEGAS: importance sampling by a learned piecewise constant density);
// Rath et al. 2022 (the cost under the root);
// Clarberg et al. 2005 (hierarchical warping); defensive mixture: Hesterberg 1995.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/base/state_archive.h"
#include "aips/core/sampling/primary_point.h"
#include "aips/core/trees/constants.h"
#include "aips/core/trees/split_gain.h"

namespace aips {

struct PrimaryTreeSettings {
    std::uint32_t max_leaves = 4096;  ///< in [1, 2^24]
    /// Photons with a score (or seeds) that a leaf must have met before it is split, >= 1.
    std::uint32_t split_count = kStartSplitScores;
    /// Least fall of the tree's mass by a split, as a share of the whole.
    double split_gain = kLeastSplitGain;
    /// Scored photon paths that count in full; older ones are forgotten in proportion.
    double memory_paths = 4e6;
    /// Power of |f| / sqrt(cost) that the density follows, in (0, 1].
    double sharpness = kStartPower;
    /// Effective scored photons that every node's prior, its parent's mean, weighs, >= 0.
    double prior_count = kStartPrior;
};

/// A point drawn from a PrimaryTree, and its density over [0, 1)^4.
struct PrimarySample {
    PrimaryPoint point;
    float pdf = 1;
};

/// How the density is mixed; what remains of 1 is the learned density.
struct PrimaryMixture {
    double plain = 1;  ///< share of the uniform density (defensive), > 0: bounds weights
    double seeds = 0;  ///< share of the density of seeds
};

/// Learns between blocks of photons by add(), add_seed() and update(); const in between, when it
/// may be used from many threads. Deterministic: a function of the sequence of calls.
class PrimaryTree {
  public:
    /// One leaf. Throws std::invalid_argument when a setting is out of range.
    explicit PrimaryTree(const PrimaryTreeSettings& settings = {});

    /// Warps u in [0, 1)^4, coordinate by coordinate and monotonically in each cell, so that the
    /// stratification of a low-discrepancy sequence survives.
    PrimarySample sample(const PrimaryPoint& u) const;
    /// Density of sample() at a point.
    float pdf(const PrimaryPoint& point) const;

    /// A photon that started at `point` was worth `score` >= 0: the square of its part in the
    /// image, at the power that it carried (which is divided by its density). It cost `cost` > 0.
    /// Others are refused.
    void add(const PrimaryPoint& point, double score, double cost = 1);
    /// A point where photons ought to start, found from the eye: shapes the density of seeds only.
    void add_seed(const PrimaryPoint& point, double weight);
    /// Halves leaves in which many of these points lie close together, as often as it takes: points
    /// found from the eye may name a millionth of all starts, and update() halves a leaf once. To
    /// be called before they are added as seeds; reorders them.
    void focus(std::span<PrimaryPoint> points);
    /// After `paths` further scored photon paths of all lights, those worth nothing included:
    /// forgets, splits what pays to be split.
    void update(double paths);
    /// What was learned counts for no more than `paths` scored photon paths, and seeds for this
    /// share of what they did; what is learned later soon outweighs it.
    void fade(double paths, double seeds);
    /// Sets the density from what was learned so far. With nothing learned (no seeds), the shares
    /// of the learned (seeds') density go to the plain one. Whatever was learned, no density is
    /// below mixture.plain by more than two parts in 100 000: no photon weighs more than 1 / that.
    void set_mixture(const PrimaryMixture& mixture);

    /// Saves what was learned, or restores it into a new tree with the same settings. To be called
    /// after update(), with nothing added since; set_mixture() has to be called again.
    void state(StateArchive& archive);

    /// Sum over leaves of volume * (expected |f| / sqrt(cost))^sharpness: what this light is worth
    /// in a choice between lights; 0 before anything was learned.
    double mass() const;
    /// Share of [0, 1)^4 where the density set last is below `density`.
    double volume_below(double density) const;
    std::uint32_t leaf_count() const { return static_cast<std::uint32_t>(leaves_.size()); }
    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes(), from the settings alone.
    static std::size_t memory_bound_bytes(const PrimaryTreeSettings& settings);

  private:
    static constexpr std::uint32_t kLeafAxis = 4;
    /// No side is halved further. Of the 48 bits of a PrimaryPoint 17 are left within such a leaf,
    /// even where photons come there by the plain density alone; and a leaf as narrow along all
    /// axes still has a density that single precision holds (2^124).
    static constexpr int kMostHalvings = 31;
    static constexpr double kMinSide = 1.0 / (std::uint64_t{1} << kMostHalvings);

    /// Interior: halves its box across an axis; children are `target` and `target` + 1. Leaf:
    /// `target` is its number. Small, as photons walk over nothing else.
    struct Node {
        float lower_share = 0.5f;  ///< probability of the lower child, given this node; in (0, 1)
        float lower_scale = 2, upper_scale = 2;  ///< 1 / lower_share, 1 / (1 - lower_share)
        std::uint32_t packed = kLeafAxis;        // target * 8 + axis

        unsigned axis() const { return packed & 7u; }
        std::uint32_t target() const { return packed >> 3; }
        bool is_leaf() const { return axis() == kLeafAxis; }
    };
    static Node leaf_node(std::uint32_t leaf) { return {.packed = leaf * 8 + kLeafAxis}; }

    /// Sums over what fell into a leaf, whole and into the lower half along each axis.
    struct Sums {
        double whole = 0;
        std::array<double, 4> lower{};

        void add(const std::array<bool, 4>& is_lower, double value);
        void scale(double factor);
        void state(StateArchive& archive);
        /// The part in the lower or upper half; how it lies along the other axes is unknown.
        Sums half(unsigned axis, bool upper) const;
    };

    /// What a node's photons are like.
    struct Means {
        double root = 0;  ///< |f|
        double cost = 1;
        double drawn_per_score = 0;  ///< photons for an effective one with a score
    };

    /// Over the leaves below a node.
    struct Totals {
        double volume = 0;
        double root = 0;      ///< integral of |f|
        double variance = 0;  ///< of that integral's estimate, plus its square over the count
        double drawn = 0;
        double cost = 0;

        void add(const Totals& other);
        double effective_count() const { return variance > 0 ? root * root / variance : 0; }
        Means blend(const Means& prior, double prior_drawn) const;
    };

    struct Leaf {
        PrimaryPoint corner{};
        PrimaryPoint side{1, 1, 1, 1};
        double volume = 1;
        double paths = 0;        ///< all lights' scored photon paths that `root` stands for
        Sums root;               ///< of sqrt(Q): `whole` / paths estimates the integral of |f|
        double score = 0;        ///< of Q
        double drawn = 0;        ///< photons that started here
        double cost = 0;         ///< of these
        Sums seeds;              ///< of seed weights
        Sums met;                ///< photons with a score and seeds
        Means expected;          ///< as of the last update()
        double probability = 1;  ///< that is set
    };

    /// A leaf and its density, as the shares on the way to it make it.
    struct Place {
        std::uint32_t leaf = 0;
        double pdf = 1;
    };

    Place locate(const PrimaryPoint& point) const;
    std::array<bool, 4> lower_halves(const Leaf& leaf, const PrimaryPoint& point) const;
    /// Axis along which the points, at least one, take little of the leaf, or kLeafAxis.
    static unsigned narrow_axis(const Leaf& leaf, std::span<const PrimaryPoint> points);
    void focus(std::uint32_t node, PrimaryPoint corner, PrimaryPoint side,
               std::span<PrimaryPoint> points);
    double leaf_mass(const Leaf& leaf) const;
    void split_leaves();
    void split(std::uint32_t node, unsigned axis);
    static Totals totals_of(const Leaf& leaf);
    void set_expectations();
    void set_probabilities();

    PrimaryTreeSettings settings_;
    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;
    // Of each node, while they are set from the leaves.
    std::vector<Totals> totals_;
    std::vector<Means> means_;
    std::vector<double> probabilities_;
};

}  // namespace aips
