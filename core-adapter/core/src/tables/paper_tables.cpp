// Learning which errors each node sees in which direction.
#include "aips/core/tables/paper_tables.h"

#include <algorithm>
#include <stdexcept>

#include "base/bounded_growth.h"

namespace aips {
namespace {

/// A photon's light is no node, nor is glass or a mirror: only segments between two surfaces that
/// take photons make neighbours.
constexpr std::uint16_t kFirstSegmentDepth = 2;

/// A table takes about a quarter of a microsecond.
constexpr std::size_t kNodesPerJob = 256;

Vec3 cell_direction(std::size_t cell, std::size_t n) {
    const auto center = [n](std::size_t i) { return (float(i) + 0.5f) / float(n); };
    return square_to_uniform_sphere({center(cell % n), center(cell / n)});
}

}  // namespace

PaperTables::PaperTables(const PaperTableSettings& settings) : settings_(settings) {
    if (settings.resolution < 1 || settings.resolution > 64) {
        throw std::invalid_argument("PaperTables: resolution must be in [1, 64]");
    }
    if (!(settings.floor_share > 0 && settings.floor_share <= 1)) {
        throw std::invalid_argument("PaperTables: floor_share must be in (0, 1]");
    }
    const auto n = static_cast<std::size_t>(settings.resolution);
    for (std::size_t cell = 0; cell < n * n; ++cell) {
        directions_.push_back(cell_direction(cell, n));
    }
    uniform_.assign(n * n, 1.0f);
}

void PaperTables::update(const NodeTree& tree, std::span<const Photon> photons,
                         const ParallelFor& parallel) {
    add_nodes(tree);
    tree.region_errors(errors_);
    for (const Photon& photon : photons) {
        if (photon.depth < kFirstSegmentDepth || photon.from_specular ||
            !is_finite(photon.position) || !is_finite(photon.previous) ||
            !is_finite(photon.direction)) {
            continue;
        }
        if (settings_.earlier_learns) {
            see(tree.locate(photon.previous), -photon.direction, tree.region(photon.position));
        }
        if (settings_.later_learns) {
            see(tree.locate(photon.position), photon.direction, tree.region(photon.previous));
        }
    }
    rebuild_all(parallel);
}

void PaperTables::resize(std::size_t nodes, std::size_t most) {
    grow_capacity(to_build_, nodes, most);
    grow_capacity(relative_, nodes * cells(), most * cells());
    to_build_.resize(nodes, 0);
    relative_.resize(nodes * cells(), 1.0f);
    if (settings_.present_errors) {
        grow_capacity(neighbours_, nodes * cells(), most * cells());
        neighbours_.resize(nodes * cells(), kNone);
    } else {
        grow_capacity(seen_, nodes * cells(), most * cells());
        seen_.resize(nodes * cells());
    }
}

void PaperTables::add_nodes(const NodeTree& tree) {
    const std::size_t old_count = to_build_.size();
    const std::size_t count = tree.node_count();
    resize(count, tree.settings().max_nodes);
    for (std::size_t i = std::max<std::size_t>(old_count, 1); i < count; ++i) {
        const std::size_t parent = tree.node(static_cast<std::uint32_t>(i)).parent;
        const auto copy = [&](auto& of_cells) {
            if (of_cells.empty()) return;
            std::copy_n(of_cells.begin() + std::ptrdiff_t(parent * cells()), cells(),
                        of_cells.begin() + std::ptrdiff_t(i * cells()));
        };
        copy(neighbours_);
        copy(seen_);
        copy(relative_);
        to_build_[i] = to_build_[parent];
    }
}

void PaperTables::see(std::uint32_t from, Vec3 direction, std::uint32_t region) {
    const std::size_t cell =
        from * cells() + cell_index(uniform_sphere_to_square(direction), settings_.resolution);
    to_build_[from] = 1;
    if (settings_.present_errors) {
        Neighbours& neighbours = neighbours_[cell];
        std::copy_backward(neighbours.begin(), neighbours.end() - 1, neighbours.end());
        neighbours.front() = region;
    } else {
        seen_[cell].sum += errors_[region];
        seen_[cell].count += 1;
    }
}

/// Errors of all nodes have changed, and so have tables that name them; but what was seen when
/// photons landed changes with new photons alone.
void PaperTables::rebuild_all(const ParallelFor& parallel) {
    const auto rebuild_some = [&](std::size_t first, std::size_t last) {
        std::vector<double> means(cells());
        for (std::size_t node = first; node < last; ++node) {
            if (!to_build_[node]) continue;
            rebuild(node, means);
            if (!settings_.present_errors) to_build_[node] = 0;
        }
    };
    in_chunks(to_build_.size(), kNodesPerJob, parallel, rebuild_some);
}

/// Of the neighbours in a cell; negative if there is none.
double PaperTables::mean_error(std::size_t cell) const {
    if (!settings_.present_errors) {
        const Seen& seen = seen_[cell];
        return seen.count > 0 ? seen.sum / seen.count : -1;
    }
    const Neighbours& neighbours = neighbours_[cell];
    double sum = 0;
    int count = 0;
    for (; count < int(neighbours.size()) && neighbours[count] != kNoRegion; ++count)
        sum += errors_[neighbours[count]];
    return count > 0 ? sum / count : -1;
}

// Eq. 5: e_w is the mean error of the neighbours in a cell. Departures: the paper interpolates
// between the vectors to the neighbours, where averages over the table's cells need no choice of
// weights; a cell remembers its last neighbours, where the paper does not say how long photons of
// earlier iterations name theirs; and it leaves directions without a neighbour open, where the
// floor keeps every direction possible (zero would lose light). The mean error of eq. 5 is that
// over the floored table, so that p(w) has mean 1.
void PaperTables::rebuild(std::size_t node, std::span<double> means) {
    const std::span<float> relative(relative_.data() + node * cells(), cells());
    double sum = 0;
    double known = 0;
    for (std::size_t i = 0; i < cells(); ++i) {
        means[i] = mean_error(node * cells() + i);
        if (means[i] < 0) continue;
        sum += means[i];
        known += 1;
    }
    const double floor = known > 0 ? settings_.floor_share * sum / known : 0.0;
    if (!(floor > 0)) {
        std::fill(relative.begin(), relative.end(), 1.0f);
        return;
    }
    double total = 0;
    for (double& mean : means) {
        mean = std::max(floor, mean);
        total += mean;
    }
    const double mean_of_all = total / double(cells());
    for (std::size_t i = 0; i < cells(); ++i)
        relative[i] = float(means[i] / mean_of_all);
}

void PaperTables::end_pass() {
    for (Seen& s : seen_) {
        if (s.count > 1) s = {s.sum / s.count, 1};
    }
}

// The tables themselves are made from what was seen.
void PaperTables::state(StateArchive& archive, const NodeTree& tree) {
    const std::size_t nodes = archive.count(to_build_.size(), cells() * kCellBytes);
    StateArchive::check(nodes <= tree.node_count(), "more tables than nodes");
    resize(nodes, tree.settings().max_nodes);
    state_of_cells(archive, tree.region_count());
    if (!archive.restoring()) return;
    tree.region_errors(errors_);
    std::fill(to_build_.begin(), to_build_.end(), std::uint8_t{1});
    rebuild_all(serial_for);
}

void PaperTables::state_of_cells(StateArchive& archive, std::size_t regions) {
    for (Neighbours& neighbours : neighbours_) {
        for (std::uint32_t& region : neighbours) {
            archive.value(region);
            StateArchive::check(region == kNoRegion || region < regions,
                                "a neighbour that is no part of the tree");
        }
    }
    for (Seen& seen : seen_) {
        archive.amount(seen.sum);
        archive.amount(seen.count);
        StateArchive::check(seen.count == 0 || seen.count >= 1, "a part of a neighbour");
    }
}

std::span<const float> PaperTables::relative_error(std::uint32_t node) const {
    if (node >= to_build_.size()) return uniform_;
    return {relative_.data() + node * cells(), cells()};
}

std::size_t PaperTables::memory_bytes() const {
    return directions_.capacity() * sizeof(Vec3) + neighbours_.capacity() * sizeof(Neighbours) +
           seen_.capacity() * sizeof(Seen) +
           (relative_.capacity() + uniform_.capacity()) * sizeof(float) + to_build_.capacity() +
           errors_.capacity() * sizeof(double);
}

std::size_t PaperTables::memory_bound_bytes(std::uint32_t max_nodes, int resolution) {
    const auto cells = static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution);
    static_assert(sizeof(Neighbours) == kCellBytes && sizeof(Seen) == kCellBytes);
    const std::size_t regions = 2;  // at most so many a node
    const std::size_t node = cells * (kCellBytes + sizeof(float)) + 1 + regions * sizeof(double);
    return max_nodes * node + 2 * cells * (sizeof(Vec3) + sizeof(float));
}

}  // namespace aips
