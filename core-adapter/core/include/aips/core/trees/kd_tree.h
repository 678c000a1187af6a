// The guide's kd-tree: space split where photons land.
// Source: Liu & Zheng 2014, section 4 and eq. 7.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/base/bounds.h"
#include "aips/core/base/state_archive.h"
#include "aips/core/trees/error_criterion.h"
#include "aips/core/trees/node.h"

namespace aips {

struct NodeTreeSettings {
    std::uint32_t max_nodes = 16384;  ///< leaves, >= 1
    std::uint32_t node_photons = 32;  ///< photons that a node holds before it splits, >= 2
    std::uint32_t max_depth = 64;     ///< splits from the root to any leaf
};

/// kd-tree over a scene's box whose leaves, the nodes, are numbered 0 .. node_count() - 1; a split
/// leaves the lower child with the number, and gives the upper the next one. Deterministic: the
/// tree is a function of the sequence of calls.
class NodeTree {
  public:
    static constexpr std::uint32_t kNoNode = 0xFFFFFFFFu;

    /// One node over `scene`; an empty or infinite box counts as the origin. Throws
    /// std::invalid_argument when a setting is out of range.
    NodeTree(const Bounds& scene, const NodeTreeSettings& settings);

    /// Puts a photon into its node, which splits when it holds more than node_photons: at the
    /// median of its photons along the longest side of its box. Where no plane separates them on
    /// that axis the next longest is tried; a leaf that cannot split (equal positions, depth, node
    /// cap) counts further photons without storing them. Returns the node before any split, or
    /// kNoNode, changing nothing, if the position is not finite or the value not in [0, inf).
    std::uint32_t insert(Vec3 position, float value);

    /// The node of a point; outside the box, that of the nearest half-spaces. Never fails.
    std::uint32_t locate(Vec3 p) const { return branches_[region(p)].target(); }

    /// A name for the part of space that is the node of a point now: it stays the same part when
    /// the node splits. Below region_count().
    std::uint32_t region(Vec3 p) const {
        std::uint32_t i = 0;
        while (branches_[i].axis() != kLeaf) {
            const Branch b = branches_[i];
            i = b.target() + (p[b.axis()] >= b.plane ? 1u : 0u);
        }
        return i;
    }
    std::uint32_t region_count() const { return static_cast<std::uint32_t>(branches_.size()); }
    /// Present errors by region: a node's own; of a region that has split the mean of its halves,
    /// as a split at the median gives each as many photons.
    void region_errors(std::vector<double>& errors) const;

    /// Eq. 7: w += N_e,i / N_e for eye rays that end at `ends`, of `total_rays` in the pass. Ends
    /// that are not finite are left out.
    void add_eye_rays(std::span<const Vec3> ends, std::uint64_t total_rays);

    /// New errors of all nodes, or, when `only_changed`, of those with new photons.
    void update_errors(const ErrorCriterion& criterion, bool only_changed);

    /// Drops the photons; structure, weights and errors stay, the errors becoming epsilon' of
    /// eq. 8.
    void end_pass();

    /// Saves the tree as end_pass() will leave it, or restores it into a new one over the same
    /// scene with the same settings.
    void state(StateArchive& archive);

    std::uint32_t node_count() const { return static_cast<std::uint32_t>(nodes_.size()); }
    const Node& node(std::uint32_t i) const { return nodes_[i]; }
    std::span<const NodePhoton> photons(std::uint32_t i) const {
        return {photons_.data() + i * slots_, nodes_[i].stored};
    }
    /// Volume of eq. 2, the sides floored at 1e-3 of the scene's diagonal.
    double volume(std::uint32_t i) const;
    const Bounds& bounds() const { return bounds_; }
    const NodeTreeSettings& settings() const { return settings_; }
    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes(), from the settings alone.
    static std::size_t memory_bound_bytes(const NodeTreeSettings& settings);

  private:
    static constexpr int kLeaf = 3;

    /// Interior: axis, plane and the lower child, the upper one being next. Leaf: its node.
    struct Branch {
        float plane = 0;
        std::uint32_t packed = kLeaf;  // target * 4 + axis

        int axis() const { return int(packed & 3u); }
        std::uint32_t target() const { return packed >> 2; }
    };
    struct SplitPlane {
        int axis = kLeaf;  // kLeaf: none found
        float plane = 0;
    };

    bool full(const Node& node) const { return node.stored >= slots_; }
    void split(std::uint32_t branch);
    void divide(std::uint32_t branch, SplitPlane plane);
    SplitPlane choose_plane(std::uint32_t node);
    SplitPlane median_plane(std::uint32_t node, int axis);
    void divide_photons(std::uint32_t lower, std::uint32_t upper, SplitPlane plane);
    std::uint32_t add_upper_child(std::uint32_t lower, SplitPlane plane);
    void store(std::uint32_t node, const NodePhoton& photon);

    NodeTreeSettings settings_;
    Bounds bounds_;
    std::size_t slots_;  // photons stored a node: one more than it may hold
    std::vector<Branch> branches_;
    std::vector<Node> nodes_;
    std::vector<NodePhoton> photons_;    // [node * slots_ + k]
    std::vector<float> coordinates_;     // scratch of median_plane
    std::vector<std::uint32_t> counts_;  // scratch of add_eye_rays
};

}  // namespace aips
