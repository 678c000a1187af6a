// A node (leaf of the guide's kd-tree) and what error criteria see of it.
#pragma once

#include <cstdint>
#include <span>

#include "aips/core/base/bounds.h"
#include "aips/core/base/vector.h"

namespace aips {

/// A photon as a node remembers it.
struct NodePhoton {
    Vec3 position;
    float value = 0;  ///< what its error criterion looks at: ErrorCriterion::value
};

/// Running mean and spread of the photons' values in one pass (Welford 1962), over all photons that
/// came, whether stored or not.
struct ValueStatistics {
    std::uint64_t count = 0;
    double mean = 0;
    double squared_deviations = 0;  ///< sum of (value - mean)^2

    void add(double value) {
        ++count;
        const double delta = value - mean;
        mean += delta / double(count);
        squared_deviations += delta * (value - mean);
    }
};

/// A leaf of the NodeTree.
struct Node {
    Bounds bounds;             ///< region of the leaf within the scene's box
    std::uint32_t depth = 0;   ///< splits above it
    std::uint32_t parent = 0;  ///< node that it split from (its own number for the first)
    std::uint32_t stored = 0;  ///< photons of this pass in the store
    bool whole = false;        ///< cannot split in this pass
    bool changed = false;      ///< photons have come since the last update of errors
    bool has_last_error = false;
    double weight = 0;      ///< w, eq. 7: share of eye rays ending here, summed over passes
    double error = 0;       ///< epsilon, eq. 2 or 8: finite, >= 0
    double last_error = 0;  ///< epsilon' of eq. 8: its value at the end of the last pass
    ValueStatistics values;
};

/// What an ErrorCriterion may look at.
struct NodeView {
    const Node& node;
    std::span<const NodePhoton> photons;  ///< stored photons of this pass
    double volume = 0;                    ///< of the node's box, each side floored
};

}  // namespace aips
