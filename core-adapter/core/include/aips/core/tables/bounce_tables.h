// Where photons ought to go on from where they scatter: learned tables of directions in the scene.
//
// A ScoreCache divides the scene, a leaf having a table of 8 x 8 cells over the normal-aligned
// cosine square, on which Lambert's lobe is uniform and the product with it therefore free; there
// is a square for each side of a surface. The square's azimuth follows the world
// (Frame::world_aligned). Nothing is done about parallax or the normals' spread within a leaf but
// to split leaves as long as they matter.
//
// Of directions drawn with density p from a vertex of power P, |f| = p sqrt(Q) / P is the part that
// the direction has in the image, Q being the score of all that came after; the sum of sqrt(Q) / P
// over those in a cell estimates the integral of |f| over it, which the density follows. That which
// minimises variance follows the root of the mean of f^2 (Rath et al. 2020), but scores have heavy
// tails, and that mean is known far later (docs/notebook/2026-11-21-directions-at-bounces.md).
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "aips/core/sampling/sampling.h"
#include "aips/core/tables/constants.h"
#include "aips/core/tables/directional_table.h"
#include "aips/core/tables/mixture_moments.h"
#include "aips/core/trees/score_cache.h"

namespace aips {

struct BounceTableSettings {
    /// A table has to be filled before it pays to halve its place.
    ScoreCacheSettings places{.max_leaves = kTableLeaves, .split_count = kTableSplitScores};
    /// Effective photons that equal shares of a square's quarters weigh, at each level, > 0.
    double prior_count = kPlacePrior;
    /// Scored paths that count in full for the choice of shares: fewer than for the tables, which
    /// become better all the time.
    double moment_paths = kShortMemoryPaths;
    ShareSettings shares{};
};

/// What became of a photon that left a vertex by a direction that was not a specular lobe's.
struct BounceScore {
    Vec3 position;
    Vec3 normal;       ///< unit, on the side where the photon arrived
    Vec3 direction;    ///< unit, away from the surface
    double power = 0;  ///< before scattering, with the vertex's roulette in it, > 0
    double score = 0;  ///< of all that came after, at that power
    double cost = 0;   ///< of all that came after, in rays
    double drawn = 0;  ///< density per steradian with which the direction was drawn
    double plain = 0;  ///< that without a table
};

/// A table in use; draws points of the cosine square about the arrival side's normal.
struct BounceTable {
    const DirectionalTable* table = nullptr;  ///< null: directions are not guided here
    float share = 0;                          ///< of directions to draw from the table
};

/// Point of the cosine square for a direction in the hemisphere of frame.n, and back. A density q
/// on the square is q cos / pi per steradian.
inline Vec2 cosine_square_point(const Frame& frame, Vec3 direction) {
    return cosine_hemisphere_to_square(frame.to_local(direction));
}
inline Vec3 cosine_square_direction(const Frame& frame, Vec2 point) {
    return frame.to_world(square_to_cosine_hemisphere(point));
}

/// Learns between blocks of photons by add() and update(). at() changes at update() alone and may
/// be called from many threads in between. Deterministic: a function of the sequence of calls.
class BounceTables {
  public:
    static constexpr int kResolution = kTableResolution;

    /// Throws std::invalid_argument when a setting is out of range.
    explicit BounceTables(const Bounds& scene, const BounceTableSettings& settings = {});

    /// The table to use at a vertex; cheap where whole regions have none.
    BounceTable at(Vec3 position, Vec3 normal) const {
        const std::uint32_t leaf = places_.marked_leaf_at(position, normal, marks_);
        return leaf == ScoreCache::kNoLeaf ? BounceTable{} : in_use_[leaf];
    }

    /// Number of the region that a vertex is in, whether its table is in use or not: for views.
    std::uint32_t region_at(Vec3 position, Vec3 normal) const {
        return places_.leaf_at(position, normal);
    }

    /// Learns from a vertex; false, learning nothing, if a number is not usable.
    bool add(const BounceScore& score);
    /// After `paths` further scored photon paths: forgets, splits, makes densities from what was
    /// learned and decides where tables pay.
    void update(double paths);

    /// What was learned counts for no more than `paths` scored photon paths. Tables in use stay so
    /// until what is learned later tells otherwise.
    void fade(double paths);

    /// Saves what was learned, or restores it into new tables over the same scene with the same
    /// settings. To be called after update(), with nothing added since.
    void state(StateArchive& archive);

    std::uint32_t leaf_count() const { return places_.leaf_count(); }
    /// Leaves whose table is in use.
    std::size_t tables_in_use() const { return tables_in_use_; }
    /// Second moment without tables over that with those in use, summed over leaves, on samples
    /// that had not shaped their tables. Costs are left out.
    double gain() const;
    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes(), from the settings alone.
    static std::size_t memory_bound_bytes(const BounceTableSettings& settings);

  private:
    static constexpr std::size_t kCells = std::size_t{kResolution} * kResolution;
    using Cells = std::array<float, kCells>;

    struct Leaf {
        std::array<double, kCells> sums{};  ///< of sqrt(Q) / P
        double sum = 0;      ///< of all cells, and of the squares: their ratio tells how many
        double squares = 0;  ///< photons with equal scores would tell as much
        double fresh = 0;    ///< part of `sum` that came after `density` was made
        Cells density{};     ///< over the square, mean 1
        bool known = false;  ///< whether there is a density
        MixtureMoments moments;
        std::size_t share = 0;                    ///< number in kTableShares
        std::unique_ptr<DirectionalTable> table;  ///< of `density`; null where share is none

        void state(StateArchive& archive);
    };

    void add_leaves();
    void forget(double paths);
    void keep(double share);
    void make_density(Leaf& leaf) const;
    void choose_shares();
    void use_tables();

    BounceTableSettings settings_;
    ScoreCache places_;
    double paths_ = 0;                 ///< that the sums stand for
    std::vector<Leaf> leaves_;         // [leaf]
    std::vector<BounceTable> in_use_;  // [leaf]
    std::vector<std::uint8_t> marks_;  // [branch of places_]: a table is in use there
    std::vector<std::uint8_t> leaf_marks_;
    MixtureMoments everywhere_;
    std::size_t tables_in_use_ = 0;
    std::uint64_t worthless_ = 0;  ///< vertices without a score
};

}  // namespace aips
