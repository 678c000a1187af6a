// Where photons bring caustics to glossy lobes, and where the eye path's own bounce does.
//
// Both find light that specular surfaces focus on such a lobe. At each place one of them carries
// it: photons where the sum V of the squares of what single ones bring is less than the variance W
// of the bounce. Both are told by photons: bounces seldom meet a small lamp behind glass, and their
// squares would say too little until it is too late.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "aips/core/tables/constants.h"
#include "aips/core/trees/score_cache.h"

namespace aips {

/// What photons told of caustics on the glossy lobes of a point: luminances.
struct GlossSample {
    Vec3 position;
    Vec3 normal;         ///< any length but 0
    double weight = 0;   ///< of a squared error there, >= 0
    double light = 0;    ///< what photons bring
    double photons = 0;  ///< V times photon paths
    double bounce = 0;   ///< W
};

/// What passes will be like.
struct GlossCosts {
    double photon_paths = 0;  ///< in each
    double price = 0;         ///< weighed variance that gathering photons at a point has to save
};

/// Learns between passes by add() and update(); at() changes at choose() and update() alone and may
/// be called from many threads in between. Deterministic: a function of the calls.
class GlossTable {
  public:
    explicit GlossTable(const Bounds& scene);

    /// Whether photons carry caustics there. They do until more is known: their noise goes away,
    /// bright dots of bounces stay.
    bool at(Vec3 position, Vec3 normal) const {
        return leaves_[places_.leaf_at(position, normal)].by_photons;
    }
    /// Learns from a point; false, learning nothing, if a number is not usable.
    bool add(const GlossSample& sample);
    /// After `samples` calls of add(): splits leaves. Of a new leaf is true what was of its parent.
    void update(std::size_t samples);
    /// Chooses by what was learned, which then counts for `memory` of what will be.
    void choose(const GlossCosts& costs, double memory);

    /// To be called after update(), with nothing added since.
    void state(StateArchive& archive);
    std::size_t memory_bytes() const;
    static std::size_t memory_bound_bytes();

  private:
    /// Weighed sums over points.
    struct Sums {
        double points = 0;
        double photons = 0, spread = 0;  ///< V times photon paths, and its square
        double bounce = 0;               ///< W

        void add(const Sums& other);
        void scale(double factor);
        void state(StateArchive& archive);
        bool photons_pay(const GlossCosts& costs) const;
    };
    struct Leaf {
        Sums sums;
        bool by_photons = true;
    };
    void add_leaves();

    ScoreCache places_;
    Sums everywhere_;
    std::vector<Leaf> leaves_;
};

}  // namespace aips
