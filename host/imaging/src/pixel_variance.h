// The variance of each pixel's mean over passes, from batches of passes.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "film_accumulator.h"
#include "lxs/sdk/state_archive.h"
#include "pass_batches.h"

namespace lxs {

/// Of the image that a FilmAccumulator holds, all light groups together. Per pixel it keeps the
/// means when the last batch ended, and sums over batches of what moved them since the batch
/// before, squared (see PassBatches): 24 bytes, 60 where passes have a second part, whatever the
/// number of passes. What passes have in common (photons that share the first passes' eye paths,
/// chains that go on) is in it as far as it lies within one batch.
class PixelVariance {
  public:
    explicit PixelVariance(std::size_t pixels) : first_(pixels) {}

    /// Takes note of a pass with these weights that `film` holds now. Costs nothing but where a
    /// batch ends.
    void end_pass(const FilmAccumulator& film, const PairOfWeights& weights);
    void clear();

    /// Whether variances are known: not before the second batch.
    bool known() const { return batches_.completion()[0] > 0; }
    const PassBatches& batches() const { return batches_; }
    /// Variance of R, G and B of the pixel, whose means are `now`; at least 0.
    Imath::V3d variance(std::size_t pixel, const PixelMeans& now) const;

    /// Throws StateError if what is restored is not of as many pixels, or no possible state.
    void state(StateArchive& archive);
    std::size_t memory_bytes() const;

  private:
    using Color = std::array<float, 3>;
    struct First {
        Color mean{}, squares{};
    };
    struct Second {
        Color mean{}, products{}, squares{};
    };
    void end_batch(const FilmAccumulator& film);

    PassBatches batches_;
    std::vector<First> first_;
    std::vector<Second> second_;  ///< empty without a second part
};

}  // namespace lxs
