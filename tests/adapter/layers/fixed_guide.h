// A guide that learns nothing and whose nodes are known.
#pragma once

#include <vector>

#include "aips/adapter/guide.h"

namespace mock {

/// Node 0 is left of x = 2; right of it node 1 lies above y = 1 (smaller y) and node 2 below.
class FixedGuide final : public aips::Guide {
  public:
    explicit FixedGuide(std::vector<aips::GuideNode> nodes) : nodes_(std::move(nodes)) {}
    std::uint32_t node_at(aips::Vec3 position) const override {
        if (position.x < 2) return 0;
        return position.y < 1 ? 1 : 2;
    }
    aips::GuideNode node(std::uint32_t number) const override { return nodes_[number]; }
    aips::GuideStatistics statistics() const override { return {nodes_.size(), 0, 0}; }

    void begin_pass(std::span<const aips::Vec3>, std::uint64_t) override {}
    std::uint32_t iteration_paths(std::uint64_t) const override { return 1; }
    bool guides(std::uint64_t) const override { return false; }
    bool learns_from_owned() const override { return false; }
    bool needs_scores() const override { return false; }
    void update(std::span<const aips::Photon>, std::span<const double>) override {}
    void state(aips::StateArchive&) override {}
    const aips::GuidedDirections* directions(const aips::GuideVertex&,
                                             std::pmr::memory_resource&) const override {
        return nullptr;
    }

  private:
    std::vector<aips::GuideNode> nodes_;
};

}  // namespace mock
