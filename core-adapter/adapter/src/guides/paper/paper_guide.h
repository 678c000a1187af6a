// guide=paper: the adaptive importance photon shooting of Liu & Zheng 2014.
//
// Where the text leaves room or is not exact, the choice made is marked "departure" at its place;
// docs/understand/paper-guide.md lists them together.
#pragma once

#include <memory>

#include "aips/adapter/guide.h"
#include "aips/adapter/settings.h"
#include "aips/core/base/bounds.h"
#include "aips/core/tables/paper_tables.h"
#include "aips/core/trees/error_criterion.h"
#include "aips/core/trees/kd_tree.h"

namespace aips {

class PaperGuide final : public Guide {
  public:
    PaperGuide(const Bounds& scene, const Settings& settings);

    void begin_pass(std::span<const Vec3> visible_points, std::uint64_t eye_paths) override;
    std::uint32_t iteration_paths(std::uint64_t iteration) const override;
    bool guides(std::uint64_t iteration) const override { return iteration > 0; }
    const GuidedDirections* directions(const GuideVertex& vertex,
                                       std::pmr::memory_resource& memory) const override;
    /// Not of the image's error: what shadow rays own is worth nothing as photons.
    bool learns_from_owned() const override { return direct_photons_ && !needs_scores(); }
    bool needs_scores() const override { return criterion_->needs_scores(); }
    void update(std::span<const Photon> photons, std::span<const double> scores) override;
    GuideStatistics statistics() const override;
    std::uint32_t node_at(Vec3 position) const override { return tree_.locate(position); }
    GuideNode node(std::uint32_t number) const override;
    void state(StateArchive& archive) override;

    const NodeTree& tree() const { return tree_; }
    const PaperTables& tables() const { return tables_; }

    static std::size_t memory_bound_bytes(const Settings& settings);

  private:
    std::uint32_t initial_photons_, iteration_photons_;
    float share_;
    bool direct_photons_;
    std::unique_ptr<const ErrorCriterion> criterion_;  // never null
    NodeTree tree_;
    PaperTables tables_;
    std::vector<Vec3> first_points_;  // visible points of the first pass, until the tree is split
    std::uint64_t first_eye_paths_ = 0;
    std::uint64_t passes_ = 0, updates_ = 0;
};

}  // namespace aips
