// What a film knows of its own error.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "film_accumulator.h"
#include "film_bias.h"
#include "lxs/imaging/error_estimate.h"
#include "pixel_variance.h"

namespace lxs {

/// Watches the passes that a film gets. It reads the film's sums and never changes them.
class FilmError {
  public:
    FilmError(std::uint32_t width, std::uint32_t height);

    /// What the pass that is under way has brought.
    void add(const PassSamples& samples);
    void add(const PassSplats& splats);
    /// The pass is over; `film` holds it.
    void end_pass(const FilmAccumulator& film);
    void clear();

    bool known() const { return variance_.known(); }
    /// `bias`: of the same passes, or null if it isn't known.
    std::optional<ErrorEstimate> estimate(const FilmAccumulator& film,
                                          const FilmBias* bias = nullptr) const;
    /// Standard deviation of each pixel's mean over passes, radiance.
    void standard_errors(const FilmAccumulator& film, std::span<Rgb> values) const;

    /// Throws StateError if what is restored doesn't fit this film.
    void state(StateArchive& archive);
    std::size_t memory_bytes() const { return variance_.memory_bytes(); }

  private:
    std::size_t pixels() const { return std::size_t{width_} * height_; }

    std::uint32_t width_, height_;
    PixelVariance variance_;
    PairOfWeights pass_{};    ///< weights of the pass under way, per pixel
    double pass_splats_ = 0;  ///< samples that its splats stand for, per pixel
};

}  // namespace lxs
