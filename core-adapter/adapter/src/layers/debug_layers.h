// What a render knows besides its image, as extra layers of the film (docs/reference/layers.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "estimate/gather.h"
#include "layers/node_layers.h"
#include "layers/table_layers.h"

namespace aips {

/// The debug layers of a render. They only read: the image is the same with and without them, and
/// they depend on the number of threads as little as it does.
class DebugLayers {
  public:
    /// The film and the guide outlive the layers; `guide` may be null, its layers then don't exist.
    DebugLayers(Film& film, const Guide* guide);

    /// Adds a pass that the film has. `flux` counts photons per visible point, found within `radii`
    /// (0: no photons were shot); `bounces` is not null with a guide.
    void add_pass(const EyeImage& image, const PhotonFlux& flux, const GatherRadii& radii,
                  const FilmPass& pass, const BounceStatistics* bounces);

    /// After add_pass(), with the tables of directions that guide=adaptive has in use.
    void add_tables(const EyeImage& image, const BounceTables& tables);

    /// Between passes: saves what later layers go on from, or restores it; the layers themselves
    /// are the film's.
    void state(StateArchive& archive);

    std::size_t memory_bytes() const;
    /// Bound of memory_bytes() and of the bounce statistics. `nodes`: most nodes of the guide, 0
    /// without.
    static std::size_t memory_bound_bytes(std::size_t pixels, std::size_t eye_paths,
                                          std::uint32_t nodes);

  private:
    void find_pixels(std::span<const Vec2> positions);
    void add_photon_part(const FilmPass& pass);
    void add_photon_density(const EyeImage& image, const PhotonFlux& flux, const GatherRadii& radii,
                            double weight);

    /// Of photon densities seen in a pixel, over all passes.
    struct WeightedSum {
        double weight = 0;
        double sum = 0;
    };

    Film& film_;
    std::vector<std::uint32_t> pixel_of_path_;
    std::vector<Rgb> photon_part_;        // [eye path]
    std::vector<WeightedSum> densities_;  // [pixel]
    std::vector<float> density_layer_;    // [pixel]
    std::optional<NodeLayers> node_layers_;
    std::optional<TableLayers> table_layers_;  // once there are tables
};

}  // namespace aips
