// The splits that made a tree, in their order: all that has to be saved of its structure, and
// nothing that could be restored to anything but a tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "aips/core/base/state_archive.h"

namespace aips {

/// Most leaves of a tree whose branches pack their child and their axis in 32 bits.
inline constexpr std::uint32_t kMostLeaves = 1u << 24;

/// [split]: the branch that it divided, for trees whose split number k appends the branches
/// roots + 2 k and roots + 2 k + 1. `Branch` has axis(), which is `leaf_axis` for leaves, and
/// target(), the lower child of others.
template <class Branch>
std::vector<std::uint32_t> split_order(const std::vector<Branch>& branches, std::size_t roots,
                                       unsigned leaf_axis) {
    std::vector<std::uint32_t> divided((branches.size() - roots) / 2);
    for (std::size_t i = 0; i < branches.size(); ++i) {
        if (unsigned(branches[i].axis()) == leaf_axis) continue;
        divided[(branches[i].target() - roots) / 2] = static_cast<std::uint32_t>(i);
    }
    return divided;
}

/// Saves the splits of a tree, or restores them into one that has nothing but its `roots`: at most
/// `most`. `divide(branch, axis)` is called in their order; restoring it appends the two children,
/// and either way goes on to save or restore what else belongs to the split.
template <class Branch, class Divide>
void state_of_splits(StateArchive& archive, const std::vector<Branch>& branches, std::size_t roots,
                     unsigned leaf_axis, std::size_t most, Divide&& divide) {
    std::vector<std::uint32_t> order;
    if (!archive.restoring()) order = split_order(branches, roots, leaf_axis);
    const std::size_t splits = archive.count(order.size(), sizeof(std::uint32_t) + 1);
    StateArchive::check(splits <= most, "a tree with too many leaves");
    for (std::size_t k = 0; k < splits; ++k) {
        std::uint32_t branch = archive.restoring() ? 0 : order[k];
        archive.value(branch);
        StateArchive::check(branch < branches.size(), "a tree without the branch that it divides");
        auto axis = static_cast<std::uint8_t>(branches[branch].axis());
        StateArchive::check(!archive.restoring() || axis == leaf_axis, "a branch divided twice");
        archive.value(axis);
        StateArchive::check(axis < leaf_axis, "a split across no axis");
        divide(branch, axis);
    }
}

}  // namespace aips
