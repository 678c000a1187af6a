// The paper's directional tables: errors of the nodes that each node sees.
// Source: Liu & Zheng 2014, sections 5.2 and 5.3, eq. 5 and 6.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/base/parallel.h"
#include "aips/core/photon_map/photon.h"
#include "aips/core/sampling/sampling.h"
#include "aips/core/tables/directional_table.h"
#include "aips/core/trees/kd_tree.h"

namespace aips {

struct PaperTableSettings {
    int resolution = 8;  ///< cells a side, 1 to 64
    /// Least error of a direction, as a share of the mean over directions with a neighbour; in
    /// (0, 1]. Directions without a neighbour get it too.
    float floor_share = 0.1f;
    /// Whether eq. 5 takes the errors that neighbours have when a table is made, by the last few
    /// seen in each direction; else those that they had when each photon landed, of all photons.
    bool present_errors = true;
    /// Which end of a segment takes the other for its neighbour: the earlier one learns where its
    /// photons go, the later one (the paper read literally) where those that it got were last.
    bool earlier_learns = true;
    bool later_learns = false;
};

/// One table of p(w) = e_w / mean e (eq. 5) a node, on the cylindrical equal-area square of world
/// directions (square_to_uniform_sphere).
class PaperTables {
  public:
    /// Throws std::invalid_argument when a setting is out of range.
    explicit PaperTables(const PaperTableSettings& settings);

    /// After an iteration: makes tables for new nodes (copies of those that they split from), takes
    /// in the neighbours that the photons name, and rebuilds the tables of all nodes that know
    /// neighbours (without present_errors: of those that photons name).
    void update(const NodeTree& tree, std::span<const Photon> photons,
                const ParallelFor& parallel = serial_for);
    /// At the end of a pass: without present_errors, what each direction has learned counts as one
    /// neighbour from now on.
    void end_pass();

    /// Saves what was learned, or restores it into new tables with the same settings, for a tree
    /// that has been restored.
    void state(StateArchive& archive, const NodeTree& tree);

    /// p(w) of a node, n * n cells in the layout of DirectionalTable::build, each > 0, mean 1;
    /// uniform for a node that has never been updated.
    std::span<const float> relative_error(std::uint32_t node) const;
    /// Unit world direction at the centre of each cell.
    std::span<const Vec3> cell_directions() const { return directions_; }
    int resolution() const { return settings_.resolution; }

    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes() for trees of at most `max_nodes`.
    static std::size_t memory_bound_bytes(std::uint32_t max_nodes, int resolution);

  private:
    /// NodeTree's regions where the last photons landed that went one way, the newest first.
    using Neighbours = std::array<std::uint32_t, 4>;
    static constexpr std::uint32_t kNoRegion = 0xFFFFFFFFu;
    static constexpr std::size_t kCellBytes = 16;  // of Neighbours, and of Seen
    static constexpr Neighbours kNone{kNoRegion, kNoRegion, kNoRegion, kNoRegion};

    /// Errors seen in one direction.
    struct Seen {
        double sum = 0;
        double count = 0;  // of photons: a float would stop at 2^24
    };

    void resize(std::size_t nodes, std::size_t most);
    void add_nodes(const NodeTree& tree);
    void see(std::uint32_t from, Vec3 direction, std::uint32_t region);
    void rebuild_all(const ParallelFor& parallel);
    void rebuild(std::size_t node, std::span<double> means);
    double mean_error(std::size_t cell) const;
    void state_of_cells(StateArchive& archive, std::size_t regions);
    std::size_t cells() const { return directions_.size(); }

    PaperTableSettings settings_;
    std::vector<Vec3> directions_;        // [cell]
    std::vector<Neighbours> neighbours_;  // [node * cells + cell]; if present_errors
    std::vector<Seen> seen_;              // [node * cells + cell]; else
    std::vector<float> relative_;         // [node * cells + cell]
    std::vector<float> uniform_;          // [cell]
    std::vector<std::uint8_t> to_build_;  // [node]: it knows neighbours, or new ones
    std::vector<double> errors_;          // present ones by region, of the last update
};

/// Eq. 6 before normalisation: products[i] = p(w_i) * bsdf_pdf(w_i) at the cell centres w_i, ready
/// for CellWeights. `bsdf_pdf` maps a world direction to a density per steradian; what it returns
/// is sanitized. All spans have the same size.
template <class BsdfPdf>
void multiply_by_bsdf(std::span<const float> relative_error, std::span<const Vec3> directions,
                      BsdfPdf&& bsdf_pdf, std::span<float> products) {
    for (std::size_t i = 0; i < products.size(); ++i) {
        products[i] =
            sanitized_weight(relative_error[i] * sanitized_weight(bsdf_pdf(directions[i])));
    }
}

/// A direction and its density per steradian.
struct DirectionSample {
    Vec3 direction;
    float pdf = 0;
};

/// Draws a world direction from a table on the cylindrical square (a DirectionalTable or
/// CellWeights that is not empty).
template <class Table>
DirectionSample sample_direction(const Table& table, Vec2 u) {
    const SquareSample s = table.sample(u);
    return {square_to_uniform_sphere(s.point), s.pdf * (0.25f * kInvPi)};
}

/// Density per steradian of sample_direction at a unit direction.
template <class Table>
float direction_pdf(const Table& table, Vec3 direction) {
    return table.pdf(uniform_sphere_to_square(direction)) * (0.25f * kInvPi);
}

}  // namespace aips
