// guide=paper in a photon pass: it learns from photons that no visible point is near to as well.
#include <optional>

#include "contribution/iteration_scores.h"
#include "photons/pass_guide.h"

namespace aips {
namespace {

class PaperPassGuide : public PassGuide {
  public:
    PaperPassGuide(Guide& guide, const Settings& settings, const PixelImportance* importance)
        : guide_(guide) {
        if (guide.needs_scores()) scores_.emplace(*importance);
        if (settings.debug_layers) bounces_.emplace(guide, settings.max_nodes);
    }

    bool wants_points() const override { return true; }
    std::uint64_t begin_pass(const GuidedPass& pass) override {
        guide_.begin_pass(pass.positions, pass.image.positions.size());
        if (scores_) scores_->begin_pass(pass.image, pass.positions, pass.radii);
        if (bounces_) bounces_->begin_pass();
        return 0;
    }
    void guide(std::uint64_t iteration, PhotonInput& input) override {
        input.occupancy = nullptr;
        if (guide_.guides(iteration)) input.guide = &guide_;
        input.store_owned = guide_.learns_from_owned();
        input.bounces = bounces_ ? &*bounces_ : nullptr;
    }
    std::uint32_t iteration_paths(std::uint64_t iteration,
                                  std::uint32_t /*unguided*/) const override {
        return guide_.iteration_paths(iteration);
    }
    PhotonStore& photons(PhotonStore& /*waiting*/) override { return photons_; }
    std::uint64_t learn(std::uint32_t /*paths*/, const OccupancyGrid& near,
                        PhotonStore& waiting) override {
        const std::span<const Photon> photons = photons_.photons();
        guide_.update(photons, scores_ ? scores_->of(photons) : std::span<const double>());
        if (bounces_) bounces_->follow_splits();
        for (const Photon& photon : photons) {
            if (!photon.owned_by_shadow_rays && near.near_visible_point(photon.position))
                waiting.append({&photon, 1});
        }
        photons_.clear();
        return 0;
    }
    void state(StateArchive& archive) override { guide_.state(archive); }
    void add_to(EngineStatistics& s) const override {
        s.guide_nodes = guide_.statistics().nodes;
        s.guide_bytes = guide_.statistics().memory_bytes;
    }
    std::size_t memory_bytes() const override {
        return guide_.statistics().memory_bytes + photons_.memory_bytes() +
               (bounces_ ? bounces_->memory_bytes() : 0) + (scores_ ? scores_->memory_bytes() : 0);
    }
    const BounceStatistics* bounces() const override { return bounces_ ? &*bounces_ : nullptr; }

  private:
    Guide& guide_;
    PhotonStore photons_;                      // of one iteration
    std::optional<IterationScores> scores_;    // if the guide learns from them
    std::optional<BounceStatistics> bounces_;  // for debug layers
};

}  // namespace

std::unique_ptr<PassGuide> make_paper_pass_guide(Guide& guide, const Settings& settings,
                                                 const PixelImportance* importance) {
    return std::make_unique<PaperPassGuide>(guide, settings, importance);
}

}  // namespace aips
