// What a photon contributes to the image where it scatters, and what its continuation costs:
// learned in the scene, for Russian roulette by score.
//
// Six kd-trees, one for each dominant direction of the normal, so that the two faces of a thin wall
// never mix. A photon of throughput T that continues with probability s ~ T sqrt(q / c), q its
// squared score per squared throughput and c its cost, minimises variance times cost; over leaves
// that hold the sums S of q and C of c what is left is (sum of sqrt(S C))^2, the measure by which
// leaves split. Sources: Bolin & Meyer 1997 and Rath et al. 2022 (the most efficient roulette goes
// with the root of second moment over cost); Vorba & Krivanek 2016 (a cache in the scene steers
// it).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/base/bounds.h"
#include "aips/core/base/state_archive.h"
#include "aips/core/trees/constants.h"
#include "aips/core/trees/split_gain.h"

namespace aips {

struct ScoreCacheSettings {
    std::uint32_t max_leaves = kMostLearnedLeaves;  ///< of the whole cache, in [6, 2^24]
    /// Vertices with a score above zero that a leaf must have met since it came to be before it is
    /// split, >= 4. Those without tell where others are not, however uneven scores may be.
    std::uint32_t split_count = kPlaceSplitScores;
    /// Least fall of the cache's mass, the sum of sqrt(S C), by a split, as a share of it.
    double split_gain = kLeastSplitGain;
    /// A leaf with more than this share of the cache's mass is halved even if its halves look
    /// alike: a field that is symmetric about the plane shows its shape only in the quarters.
    double split_mass = kSplitMass;
    /// Photon paths whose vertices count in full; older ones fade as exp(-paths / memory_paths).
    double memory_paths = 4e6;
    /// Vertices with a score that every node's prior weighs, > 0: the number below which what a
    /// leaf met is not trusted.
    double prior_count = kPlacePrior;
};

/// What became of a photon that continued from a scattering vertex. One that roulette ended there
/// says nothing about what continuing is worth and is not to be added.
struct VertexScore {
    Vec3 position;
    Vec3 normal;  ///< on the side where the photon arrived, any length but 0
    /// Q of all that came after the vertex / (power)^2, >= 0. The power is that before the
    /// scattering with the vertex's own roulette in it (arriving / survival): with the arriving
    /// power alone, scores would grow as 1 / survival^2 and the cache would chase its own roulette.
    double score = 0;
    double cost = 0;  ///< rays traced after it, >= 0
};

/// Learns between blocks of photons by add() and update(). at() changes at update() alone and may
/// be called from many threads in between. Deterministic: a function of the sequence of calls.
class ScoreCache {
  public:
    /// Six leaves over `scene`, whose box only places the planes: points outside it are as good as
    /// others, and an empty or infinite box counts as the origin. Throws std::invalid_argument when
    /// a setting is out of range.
    explicit ScoreCache(const Bounds& scene, const ScoreCacheSettings& settings = {});

    struct Expectation {
        float score = 0;     ///< mean VertexScore::score
        float cost = 0;      ///< mean VertexScore::cost, rays
        bool known = false;  ///< false (and zeros) before any vertex was learned
    };

    /// Of a photon that continues from a vertex: the mean over its leaf's vertices as of the last
    /// update(), joined by a prior at the parent's expectation; the parent of a tree's root is the
    /// mean over the whole cache. The prior weighs prior_count * n / m vertices, m of n having a
    /// score in the parent: where one vertex in a hundred has one, some hundred zeros prove
    /// nothing. Never fails.
    Expectation at(Vec3 position, Vec3 normal) const {
        const Means means = means_[locate(position, normal)];
        if (means.score < 0) return {};
        return {means.score, means.cost, true};
    }

    /// Learns from a vertex; false, changing nothing, if a number is not finite, negative, or
    /// beyond single precision. Vertices whose score is zero count.
    bool add(const VertexScore& vertex);
    /// add() in two steps, for many vertices on several threads: whether a vertex is usable, and in
    /// which branch it lies, can be asked from many threads; add_at(), of usable ones that lie
    /// there, of one thread for each branch.
    static bool usable(const VertexScore& vertex);
    std::uint32_t branch_at(Vec3 position, Vec3 normal) const { return locate(position, normal); }
    void add_at(std::uint32_t branch, const VertexScore& vertex);
    /// add_at() in two steps, for many vertices of one branch: what they add is summed apart by
    /// add_to(), which may be called from many threads, and joined later.
    struct Sums;
    void add_to(Sums& sums, std::uint32_t branch, const VertexScore& vertex) const;
    void add_at(std::uint32_t branch, const Sums& sums);
    /// Above all numbers of branches.
    std::uint32_t branch_end() const { return static_cast<std::uint32_t>(branches_.size()); }
    /// Number of the leaf that a branch is: see leaf_at().
    std::uint32_t leaf_of(std::uint32_t branch) const { return branches_[branch].target(); }
    /// After `paths` further photon paths: forgets, splits what pays to be split, and sets the
    /// expectations from what was learned so far.
    void update(double paths);

    /// What was learned counts for no more than `paths` photon paths; what is learned later soon
    /// outweighs it.
    void fade(double paths);

    /// Saves what was learned, or restores it into a new cache over the same scene with the same
    /// settings. To be called after update(), with nothing added since.
    void state(StateArchive& archive);

    /// No leaf, where marked_leaf_at() finds none.
    static constexpr std::uint32_t kNoLeaf = ~std::uint32_t(0);

    /// Number, below leaf_count(), of the leaf that holds a vertex. A leaf keeps its number as long
    /// as it is a leaf; of the halves of one that update() splits the lower keeps it, and the upper
    /// takes the next new one.
    std::uint32_t leaf_at(Vec3 position, Vec3 normal) const {
        return branches_[locate(position, normal)].target();
    }
    /// Number of the leaf that a leaf was split off from; its own if it was there from the start.
    std::uint32_t parent_of(std::uint32_t leaf) const { return leaves_[leaf].parent; }
    /// Fills `marks` for marked_leaf_at() from a mark for each leaf. Valid until the next update().
    void mark_branches(std::span<const std::uint8_t> leaf_marks,
                       std::vector<std::uint8_t>& marks) const;
    /// leaf_at() where that leaf is marked, else kNoLeaf: found without going further down than to
    /// where all leaves are unmarked.
    std::uint32_t marked_leaf_at(Vec3 position, Vec3 normal,
                                 std::span<const std::uint8_t> marks) const {
        std::uint32_t i = root_of(normal);
        for (; marks[i]; i = child(branches_[i], position)) {
            if (branches_[i].axis() == kLeaf) return branches_[i].target();
        }
        return kNoLeaf;
    }

    std::uint32_t leaf_count() const { return static_cast<std::uint32_t>(leaves_.size()); }
    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes(), from the settings alone.
    static std::size_t memory_bound_bytes(const ScoreCacheSettings& settings);

  private:
    static constexpr int kLeaf = 3;
    static constexpr std::uint32_t kTrees = 6;

    /// Interior: axis, plane and the lower child, the upper one being next. Leaf: its number. The
    /// first six are the roots; children come after their parents.
    struct Branch {
        float plane = 0;
        std::uint32_t packed = kLeaf;  // target * 4 + axis

        int axis() const { return int(packed & 3u); }
        std::uint32_t target() const { return packed >> 2; }
    };

    /// Expectations of a node; a negative score: nothing is known.
    struct Means {
        float score = -1;
        float cost = 0;
    };

    /// Sums over the vertices below a node.
    struct Totals {
        double count = 0;
        double scored = 0;  ///< of them, with a score above zero
        double root = 0;    ///< of sqrt(score), whose second moment is `score`
        double score = 0;
        double cost = 0;

        void add(const Totals& other);
        void scale(double factor);
        void state(StateArchive& archive);
        Means blend(Means prior, double prior_weight) const;
    };

    /// A sum over a leaf's vertices, whole and of those in the lower half along each axis.
    struct HalfSums {
        double whole = 0;
        std::array<double, 3> lower{};

        void add(const std::array<bool, 3>& is_lower, double value);
        void add(const HalfSums& other);
        void scale(double factor);
        double half(int axis, bool upper) const;
        void state(StateArchive& archive);
    };

    /// What a leaf met since it came to be, or since its box was last fitted.
    struct Probe {
        HalfSums count;
        HalfSums scored;
        HalfSums root;
        HalfSums score;
        HalfSums cost;

        void add(const Probe& other);
        void scale(double factor);
        Totals whole() const;
        Totals half(int axis, bool upper) const;
        double gain(int axis) const;
        bool halves_differ(int axis) const;
        bool shares_differ(int axis) const;
    };

    struct Leaf {
        Bounds box;  ///< where its vertices lie, roughly; its middle planes are those of `probe`
        Bounds met;  ///< of all vertices met
        std::uint32_t parent = 0;
        Probe probe;
    };

    struct Split {
        double gain = 0;
        std::uint32_t branch = 0;
        int axis = kLeaf;  ///< kLeaf: none
    };

    static std::uint32_t root_of(Vec3 normal) {
        const int axis = dominant_axis(normal);
        return 2u * std::uint32_t(axis) + (normal[axis] < 0 ? 1u : 0u);
    }
    std::uint32_t locate(Vec3 position, Vec3 normal) const {
        std::uint32_t i = root_of(normal);
        while (branches_[i].axis() != kLeaf)
            i = child(branches_[i], position);
        return i;
    }
    static std::uint32_t child(Branch b, Vec3 position) {
        return b.target() + (position[b.axis()] >= b.plane ? 1u : 0u);
    }
    /// Adds a vertex of a leaf with this box.
    static void add(Totals& totals, Bounds& met, Probe& probe, const Bounds& box,
                    const VertexScore& vertex);
    float fitted_side(const Leaf& leaf, int axis) const;
    bool fit_box(Leaf& leaf) const;
    bool divisible(const Leaf& leaf, int axis) const;
    double leaf_mass(std::uint32_t branch) const;
    Split best_split(std::uint32_t branch, double whole_mass) const;
    void forget(double most);
    void split_leaves();
    void split(const Split& split);
    void add_totals();
    double prior_weight(const Totals& parent) const;
    void set_means();

    ScoreCacheSettings settings_;
    float min_side_;
    double paths_ = 0;  ///< that the sums stand for
    std::vector<Branch> branches_;
    std::vector<Means> means_;    // of each branch
    std::vector<Totals> totals_;  // of each branch; interior ones are set in update()
    std::vector<Leaf> leaves_;
};

/// What vertices of one branch add to its leaf.
struct ScoreCache::Sums {
    Totals totals;
    Bounds met;
    Probe probe;
};

}  // namespace aips
