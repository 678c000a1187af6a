// Splitting, filling and weighing the nodes of the guide's kd-tree.
#include "aips/core/trees/kd_tree.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/bounded_growth.h"
#include "trees/split_order.h"
#include "trees/usable_bounds.h"

namespace aips {
namespace {

/// Least side of a paper's node in eq. 2. The plain volume is zero for a node that holds a flat
/// piece of an axis-aligned surface (share of the scene's diagonal).
constexpr double kMinSideShare = 1e-3;

constexpr std::uint32_t kMaxNodes = 1u << 28;
constexpr std::uint32_t kMaxNodePhotons = 1u << 20;

void check(const NodeTreeSettings& s) {
    if (s.max_nodes < 1 || s.max_nodes > kMaxNodes) {
        throw std::invalid_argument("NodeTree: max_nodes must be in [1, 2^28]");
    }
    if (s.node_photons < 2 || s.node_photons > kMaxNodePhotons) {
        throw std::invalid_argument("NodeTree: node_photons must be in [2, 2^20]");
    }
}

/// Axes from the longest side of the box to the shortest; the lowest axis wins a tie.
std::array<int, 3> axes_by_length(const Bounds& box) {
    std::array<int, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) {
        return double(box.upper[a]) - double(box.lower[a]) >
               double(box.upper[b]) - double(box.lower[b]);
    });
    return axes;
}

/// A plane with a < plane <= b.
float plane_between(float a, float b) {
    const float middle = 0.5f * a + 0.5f * b;
    return middle > a && middle <= b ? middle : b;
}

}  // namespace

NodeTree::NodeTree(const Bounds& scene, const NodeTreeSettings& settings)
    : settings_(settings),
      bounds_(usable_bounds(scene)),
      slots_(std::size_t(settings.node_photons) + 1) {
    check(settings);
    branches_.push_back({});
    nodes_.push_back({});
    nodes_[0].bounds = bounds_;
    photons_.resize(slots_);
}

std::uint32_t NodeTree::insert(Vec3 position, float value) {
    if (!is_finite(position) || !std::isfinite(value) || value < 0) return kNoNode;
    const std::uint32_t branch = region(position);
    const std::uint32_t node = branches_[branch].target();
    store(node, {position, value});
    if (full(nodes_[node]) && !nodes_[node].whole) split(branch);
    return node;
}

void NodeTree::store(std::uint32_t i, const NodePhoton& photon) {
    Node& node = nodes_[i];
    node.values.add(double(photon.value));
    node.changed = true;
    if (!full(node)) photons_[i * slots_ + node.stored++] = photon;
}

void NodeTree::split(std::uint32_t branch) {
    const std::uint32_t lower = branches_[branch].target();
    const bool allowed =
        nodes_[lower].depth < settings_.max_depth && node_count() < settings_.max_nodes;
    const SplitPlane plane = allowed ? choose_plane(lower) : SplitPlane{};
    if (plane.axis == kLeaf) {
        nodes_[lower].whole = true;
        return;
    }
    divide(branch, plane);
}

void NodeTree::divide(std::uint32_t branch, SplitPlane plane) {
    const std::uint32_t lower = branches_[branch].target();
    const std::uint32_t upper = add_upper_child(lower, plane);
    divide_photons(lower, upper, plane);
    const auto child = static_cast<std::uint32_t>(branches_.size());
    grow_capacity(branches_, child + 2, 2 * std::size_t(settings_.max_nodes) - 1);
    branches_.push_back({0, lower * 4 + kLeaf});
    branches_.push_back({0, upper * 4 + kLeaf});
    branches_[branch] = {plane.plane, child * 4 + std::uint32_t(plane.axis)};
}

// Departure: where no plane across the longest side separates the photons, the others are tried;
// the paper does not say what happens to photons with equal coordinates.
NodeTree::SplitPlane NodeTree::choose_plane(std::uint32_t node) {
    for (const int axis : axes_by_length(nodes_[node].bounds)) {
        const SplitPlane plane = median_plane(node, axis);
        if (plane.axis != kLeaf) return plane;
    }
    return {};
}

/// The plane across `axis` nearest to the photons' median that has photons on both sides and lies
/// within the node.
NodeTree::SplitPlane NodeTree::median_plane(std::uint32_t i, int axis) {
    const Bounds& box = nodes_[i].bounds;
    coordinates_.clear();
    for (const NodePhoton& photon : photons(i))
        coordinates_.push_back(photon.position[axis]);
    std::sort(coordinates_.begin(), coordinates_.end());
    const std::size_t count = coordinates_.size();
    const std::size_t median = count / 2;
    const auto try_gap = [&](std::size_t k) -> SplitPlane {  // between photons k - 1 and k
        if (k < 1 || k >= count || coordinates_[k - 1] == coordinates_[k]) return {};
        const float plane = plane_between(coordinates_[k - 1], coordinates_[k]);
        return plane > box.lower[axis] && plane <= box.upper[axis] ? SplitPlane{axis, plane}
                                                                   : SplitPlane{};
    };
    for (std::size_t off = 0; off <= median; ++off) {
        if (const auto below = try_gap(median - off); below.axis != kLeaf) return below;
        if (const auto above = try_gap(median + off); above.axis != kLeaf) return above;
    }
    return {};
}

/// A copy of the node with its weight and errors (paper, section 6: both are copied, so that a
/// split counts the weight twice; only ratios matter, and passes to come set them right).
std::uint32_t NodeTree::add_upper_child(std::uint32_t lower, SplitPlane plane) {
    const std::uint32_t upper = node_count();
    const std::size_t nodes = std::size_t(upper) + 1;
    grow_capacity(nodes_, nodes, settings_.max_nodes);
    grow_capacity(photons_, nodes * slots_, settings_.max_nodes * slots_);
    photons_.resize(nodes * slots_);
    ++nodes_[lower].depth;
    nodes_.push_back(Node(nodes_[lower]));
    nodes_[upper].parent = lower;
    nodes_[lower].bounds.upper[plane.axis] = plane.plane;
    nodes_[upper].bounds.lower[plane.axis] = plane.plane;
    return upper;
}

void NodeTree::divide_photons(std::uint32_t lower, std::uint32_t upper, SplitPlane plane) {
    const std::uint32_t count = nodes_[lower].stored;
    for (const std::uint32_t child : {lower, upper}) {
        nodes_[child].stored = 0;
        nodes_[child].values = {};
    }
    for (std::uint32_t k = 0; k < count; ++k) {
        const NodePhoton photon = photons_[lower * slots_ + k];  // k never lags behind the writes
        store(photon.position[plane.axis] >= plane.plane ? upper : lower, photon);
    }
}

void NodeTree::add_eye_rays(std::span<const Vec3> ends, std::uint64_t total_rays) {
    if (total_rays == 0) return;
    grow_capacity(counts_, nodes_.size(), settings_.max_nodes);
    counts_.assign(nodes_.size(), 0);
    for (const Vec3& end : ends) {
        if (is_finite(end)) ++counts_[locate(end)];
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        nodes_[i].weight += double(counts_[i]) / double(total_rays);
    }
}

void NodeTree::update_errors(const ErrorCriterion& criterion, bool only_changed) {
    for (std::uint32_t i = 0; i < node_count(); ++i) {
        Node& node = nodes_[i];
        if (only_changed && !node.changed) continue;
        const double error = criterion.error({node, photons(i), volume(i)});
        if (std::isfinite(error) && error >= 0) node.error = error;
        node.changed = false;
    }
}

void NodeTree::region_errors(std::vector<double>& errors) const {
    grow_capacity(errors, branches_.size(), 2 * std::size_t(settings_.max_nodes) - 1);
    errors.resize(branches_.size());
    for (std::size_t i = branches_.size(); i-- > 0;) {  // children come after their parents
        const Branch b = branches_[i];
        errors[i] = b.axis() == kLeaf ? nodes_[b.target()].error
                                      : 0.5 * errors[b.target()] + 0.5 * errors[b.target() + 1];
    }
}

void NodeTree::end_pass() {
    for (Node& node : nodes_) {
        node.has_last_error = node.has_last_error || node.values.count >= 2;
        node.last_error = node.error;
        node.stored = 0;
        node.values = {};
        node.whole = false;
        node.changed = false;
    }
}

// Photons and what they left in their nodes end with the pass.
void NodeTree::state(StateArchive& archive) {
    const auto divide_box = [&](std::uint32_t branch, int axis) {
        float plane = branches_[branch].plane;
        archive.value(plane);
        if (!archive.restoring()) return;
        const Node& node = nodes_[branches_[branch].target()];
        StateArchive::check(plane > node.bounds.lower[axis] && plane <= node.bounds.upper[axis] &&
                                node.depth < settings_.max_depth,
                            "a node of the guide's tree that could not be divided");
        divide(branch, {axis, plane});
    };
    state_of_splits(archive, branches_, 1, kLeaf, settings_.max_nodes - 1, divide_box);
    for (Node& node : nodes_) {
        archive.amount(node.weight);
        archive.amount(node.error);
        bool has_error = node.has_last_error || node.values.count >= 2;
        archive.value(has_error);
        if (!archive.restoring()) continue;
        node.has_last_error = has_error;
        node.last_error = node.error;
    }
}

double NodeTree::volume(std::uint32_t i) const {
    const Bounds& box = nodes_[i].bounds;
    double diagonal_squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double side = double(bounds_.upper[axis]) - double(bounds_.lower[axis]);
        diagonal_squared += side * side;
    }
    const double floor = kMinSideShare * std::sqrt(diagonal_squared);
    double volume = 1;
    for (int axis = 0; axis < 3; ++axis) {
        volume *= std::max(floor, double(box.upper[axis]) - double(box.lower[axis]));
    }
    return volume;
}

std::size_t NodeTree::memory_bytes() const {
    return branches_.capacity() * sizeof(Branch) + nodes_.capacity() * sizeof(Node) +
           photons_.capacity() * sizeof(NodePhoton) + coordinates_.capacity() * sizeof(float) +
           counts_.capacity() * sizeof(std::uint32_t);
}

std::size_t NodeTree::memory_bound_bytes(const NodeTreeSettings& s) {
    const std::size_t slots = std::size_t(s.node_photons) + 1;
    return std::size_t(s.max_nodes) * (2 * sizeof(Branch) + sizeof(Node) +
                                       slots * sizeof(NodePhoton) + sizeof(std::uint32_t)) +
           2 * slots * sizeof(float);
}

}  // namespace aips
