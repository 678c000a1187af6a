// Where the independent paths of Markov chains start: where visible paths were found to start
// before. See docs/understand/chain-starts.md.
#pragma once

#include <span>
#include <vector>

#include "aips/adapter/settings.h"
#include "aips/core/chains/primary_path.h"
#include "guides/adaptive/emission_guide.h"
#include "guides/adaptive/seed_search.h"

namespace aips {

/// An emission guide of which a path's part is whether it is visible. Its draws are told in the
/// coordinates that unguided paths are traced by, so that chains can walk on from them among all
/// paths alike. What is learned shapes the draws of later passes: draw() is the same from
/// begin_pass() to end_pass(), whatever is added.
class ChainStarts {
  public:
    /// `light_choice` (by power, not empty) and the others outlive this.
    ChainStarts(const Scene& scene, const Settings& settings,
                const DiscreteDistribution& light_choice);
    ChainStarts(const ChainStarts&) = delete;
    ChainStarts& operator=(const ChainStarts&) = delete;

    /// Walks from the eye while they still tell more than paths do. Returns the rays traced.
    std::uint64_t begin_pass(std::uint64_t pass, float time, const EyeImage& image);

    /// Draws a start from `random` and puts its coordinates, kEmissionCoordinates of them, in the
    /// place of `coordinates`. They choose the light exactly; to start in `point` they lack the
    /// bits beyond 32, which are drawn anew, in the same leaf of the tree.
    EmissionStart draw(RandomStream& random, std::vector<Coordinate>& coordinates) const;
    /// Density of plain starts over that of the draw: what a path that starts so stands for.
    double weight(const EmissionStart& start) const {
        return double(light_choice_.pdf(start.light)) / start.pdf;
    }
    /// The start that a path's coordinates mean; `pdf` is not set.
    EmissionStart at(std::span<const Coordinate> coordinates) const;

    /// Of how many drawn paths one is to be added.
    std::uint32_t learn_one_of() const;
    /// What became of a drawn path; `cost` in rays.
    void add(const EmissionStart& start, bool visible, double cost);
    /// A visible path that chains came by and that stands for `share` of all plain paths, after all
    /// drawn paths that are added in this pass.
    void add_visible(const EmissionStart& start, double share, double cost);
    /// The next pass follows what was added.
    void end_pass();

    /// Whether draws are other than plain.
    bool on() const { return guide_.on(); }

    /// Between passes: saves what was learned, or restores it.
    void state(StateArchive& archive);
    /// As EmissionGuide's; walks from the eye are done anew.
    void begin_anew();
    std::uint64_t fit() const { return guide_.fit(); }
    std::size_t memory_bytes() const { return guide_.memory_bytes() + seeds_.memory_bytes(); }
    static std::size_t memory_bound_bytes(const Scene& scene, std::size_t eye_paths);

  private:
    const Scene& scene_;
    const Settings& settings_;
    const DiscreteDistribution& light_choice_;
    EmissionGuide guide_;
    SeedSearch seeds_;
    std::uint64_t paths_ = 0;  // added in earlier passes
    std::uint64_t added_ = 0;  // in this one
};

}  // namespace aips
