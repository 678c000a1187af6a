// guide=paper.
#include "guides/paper/paper_guide.h"

#include <new>

#include "base/parallel_for.h"

namespace aips {
namespace {

/// Eq. 6 at one hit: the node's p(w) times the Bsdf's density, normalised, over the table's cells.
/// Departure: the paper stores the product per node, which is impossible where Bsdfs differ within
/// a node; the product is formed here from the density at each cell's centre. Whatever that misses
/// inside a cell costs variance only, as the photon's weight uses the density really drawn from.
class PaperDirections final : public GuidedDirections {
  public:
    PaperDirections(float share, std::span<const float> products, int resolution)
        : GuidedDirections(share), weights_(products, resolution) {}

    bool empty() const { return weights_.empty(); }
    Vec3 sample(Vec2 u) const override { return sample_direction(weights_, u).direction; }
    float pdf(Vec3 direction) const override { return direction_pdf(weights_, direction); }

  private:
    CellWeights weights_;
};

NodeTreeSettings tree_settings(const Settings& s) {
    return {s.max_nodes, s.node_photons, s.tree_depth};
}

std::unique_ptr<const ErrorCriterion> make_criterion(const Settings& s) {
    if (s.error_criterion == CriterionKind::Image) {
        return std::make_unique<ImageErrorCriterion>(s.error_alpha);
    }
    return std::make_unique<PaperErrorCriterion>(s.error_alpha);
}

PaperTableSettings table_settings(const Settings& s) {
    PaperTableSettings table;
    table.resolution = static_cast<int>(s.cdf_resolution);
    table.present_errors = s.present_errors;
    table.earlier_learns = s.neighbours != NeighbourKind::Last;
    table.later_learns = s.neighbours != NeighbourKind::Reached;
    return table;
}

}  // namespace

PaperGuide::PaperGuide(const Bounds& scene, const Settings& s)
    : initial_photons_(s.initial_photons),
      iteration_photons_(s.iteration_photons),
      share_(float(s.guide_share)),
      direct_photons_(s.direct_photons),
      criterion_(make_criterion(s)),
      tree_(scene, tree_settings(s)),
      tables_(table_settings(s)) {}

void PaperGuide::begin_pass(std::span<const Vec3> visible_points, std::uint64_t eye_paths) {
    if (passes_++ > 0) {
        tree_.end_pass();
        tables_.end_pass();
        tree_.add_eye_rays(visible_points, eye_paths);
        return;
    }
    first_points_.assign(visible_points.begin(), visible_points.end());
    first_eye_paths_ = eye_paths;
}

std::uint32_t PaperGuide::iteration_paths(std::uint64_t iteration) const {
    return iteration == 0 ? initial_photons_ : iteration_photons_;
}

const GuidedDirections* PaperGuide::directions(const GuideVertex& vertex,
                                               std::pmr::memory_resource& memory) const {
    const std::span<const float> relative = tables_.relative_error(tree_.locate(vertex.position));
    const std::span<float> products(
        static_cast<float*>(memory.allocate(relative.size_bytes(), alignof(float))),
        relative.size());
    multiply_by_bsdf(
        relative, tables_.cell_directions(),
        [&](Vec3 wi) { return vertex.bsdf->pdf(vertex.wo, wi, kNonSpecular); }, products);
    const auto* directions =
        new (memory.allocate(sizeof(PaperDirections), alignof(PaperDirections)))
            PaperDirections(share_, products, tables_.resolution());
    return directions->empty() ? nullptr : directions;
}

void PaperGuide::update(std::span<const Photon> photons, std::span<const double> scores) {
    for (std::size_t i = 0; i < photons.size(); ++i) {
        const double score = scores.empty() ? 0.0 : scores[i];
        tree_.insert(photons[i].position, criterion_->value(luminance(photons[i].power), score));
    }
    if (!first_points_.empty()) {
        // Departure: in the first pass the eye rays end in a tree of one node, whose weight all
        // nodes would copy. They are counted once the first photons have split it.
        tree_.add_eye_rays(first_points_, first_eye_paths_);
        first_points_ = {};
    }
    tree_.update_errors(*criterion_, true);
    tables_.update(tree_, photons, tbb_for);
    ++updates_;
}

GuideStatistics PaperGuide::statistics() const {
    return {tree_.node_count(), tree_.memory_bytes() + tables_.memory_bytes(), updates_};
}

GuideNode PaperGuide::node(std::uint32_t number) const {
    const Node& node = tree_.node(number);
    return {node.weight, node.error, node.parent};
}

// The visible points of the first pass are dropped before its end.
void PaperGuide::state(StateArchive& archive) {
    tree_.state(archive);
    tables_.state(archive, tree_);
    archive.value(passes_);
    archive.value(updates_);
}

std::size_t PaperGuide::memory_bound_bytes(const Settings& s) {
    return NodeTree::memory_bound_bytes(tree_settings(s)) +
           PaperTables::memory_bound_bytes(s.max_nodes, static_cast<int>(s.cdf_resolution));
}

}  // namespace aips
