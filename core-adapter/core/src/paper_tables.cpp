// Learning which errors each node sees in which direction.
#include "aips/core/paper_tables.h"

#include <algorithm>
#include <stdexcept>

#include "bounded_growth.h"

namespace aips {
namespace {

/// A photon's light is no node: only segments between two surfaces make neighbours.
constexpr std::uint16_t kFirstSegmentDepth = 2;

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

void PaperTables::update(const NodeTree& tree, std::span<const Landing> landings) {
    add_nodes(tree);
    for (const Landing& landing : landings) {
        if (landing.depth < kFirstSegmentDepth || !is_finite(landing.position) ||
            !is_finite(landing.previous) || !is_finite(landing.direction)) {
            continue;
        }
        const std::uint32_t from = tree.locate(landing.previous);
        const std::uint32_t to = tree.locate(landing.position);
        see(from, -landing.direction, tree.node(to).error);
        if (settings_.both_ends) see(to, landing.direction, tree.node(from).error);
    }
    for (const std::uint32_t node : to_build_)
        rebuild(node);
    to_build_.clear();
}

void PaperTables::add_nodes(const NodeTree& tree) {
    const std::size_t old_count = touched_.size();
    const std::size_t count = tree.node_count();
    const std::size_t most = tree.settings().max_nodes;
    grow_capacity(touched_, count, most);
    grow_capacity(to_build_, count, most);
    grow_capacity(seen_, count * cells(), most * cells());
    grow_capacity(relative_, count * cells(), most * cells());
    touched_.resize(count, 0);
    seen_.resize(count * cells());
    relative_.resize(count * cells(), 1.0f);
    for (std::size_t i = std::max<std::size_t>(old_count, 1); i < count; ++i) {
        const std::size_t parent = tree.node(static_cast<std::uint32_t>(i)).parent;
        std::copy_n(seen_.begin() + std::ptrdiff_t(parent * cells()), cells(),
                    seen_.begin() + std::ptrdiff_t(i * cells()));
        std::copy_n(relative_.begin() + std::ptrdiff_t(parent * cells()), cells(),
                    relative_.begin() + std::ptrdiff_t(i * cells()));
    }
}

void PaperTables::see(std::uint32_t from, Vec3 direction, double error) {
    const std::size_t cell = cell_index(uniform_sphere_to_square(direction), settings_.resolution);
    Seen& seen = seen_[from * cells() + cell];
    seen.sum += error;
    seen.count += 1;
    if (touched_[from]) return;
    touched_[from] = 1;
    to_build_.push_back(from);
}

// Eq. 5: e_w is the mean error of the neighbours in a cell. Departures: the paper interpolates
// between the vectors to the neighbours, where averages over the table's cells need no choice of
// weights; and it leaves directions without a neighbour open, where the floor keeps every direction
// possible (zero would lose light). The mean error of eq. 5 is that over the floored table, so that
// p(w) has mean 1.
void PaperTables::rebuild(std::uint32_t node) {
    const std::span<const Seen> seen(seen_.data() + node * cells(), cells());
    const std::span<float> relative(relative_.data() + node * cells(), cells());
    touched_[node] = 0;
    double sum = 0;
    double known = 0;
    for (const Seen& s : seen) {
        if (s.count == 0) continue;
        sum += s.sum / s.count;
        known += 1;
    }
    const double floor = known > 0 ? settings_.floor_share * sum / known : 0.0;
    if (!(floor > 0)) {
        std::fill(relative.begin(), relative.end(), 1.0f);
        return;
    }
    const auto floored = [floor](const Seen& s) {
        return s.count > 0 ? std::max(floor, s.sum / s.count) : floor;
    };
    double total = 0;
    for (const Seen& s : seen)
        total += floored(s);
    const double mean = total / double(cells());
    for (std::size_t i = 0; i < cells(); ++i)
        relative[i] = float(floored(seen[i]) / mean);
}

void PaperTables::end_pass() {
    for (Seen& s : seen_) {
        if (s.count > 1) s = {s.sum / s.count, 1};
    }
}

// The tables themselves are made from what was seen.
void PaperTables::state(StateArchive& archive, const NodeTree& tree) {
    const std::size_t nodes =
        archive.count(touched_.size(), cells() * (sizeof(Seen::sum) + sizeof(Seen::count)));
    StateArchive::check(nodes <= tree.node_count(), "more tables than nodes");
    touched_.resize(nodes, 0);
    seen_.resize(nodes * cells());
    relative_.resize(nodes * cells(), 1.0f);
    for (Seen& seen : seen_) {
        archive.amount(seen.sum);
        archive.amount(seen.count);
        StateArchive::check(seen.count == 0 || seen.count >= 1, "a part of a neighbour");
    }
    if (!archive.restoring()) return;
    for (std::uint32_t node = 0; node < nodes; ++node)
        rebuild(node);
}

std::span<const float> PaperTables::relative_error(std::uint32_t node) const {
    if (node >= touched_.size()) return uniform_;
    return {relative_.data() + node * cells(), cells()};
}

std::size_t PaperTables::memory_bytes() const {
    return directions_.capacity() * sizeof(Vec3) + seen_.capacity() * sizeof(Seen) +
           (relative_.capacity() + uniform_.capacity()) * sizeof(float) + touched_.capacity() +
           to_build_.capacity() * sizeof(std::uint32_t);
}

std::size_t PaperTables::memory_bound_bytes(std::uint32_t max_nodes, int resolution) {
    const auto cells = static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution);
    const std::size_t node = cells * (sizeof(Seen) + sizeof(float)) + 1 + sizeof(std::uint32_t);
    return max_nodes * node + 2 * cells * (sizeof(Vec3) + sizeof(float));
}

}  // namespace aips
