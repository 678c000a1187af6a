// Which half of the passes a pass belongs to, and both halves' means.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "film_accumulator.h"
#include "lxs/sdk/state_archive.h"

namespace lxs {

/// Splits passes into batches that go to one of two halves each. Passes complement each other by
/// the bits of their number (Sobol points): halves by Thue and Morse's sequence get alike shares of
/// every digit, where even and odd passes would see one side of each pixel each.
class HalvesSchedule {
  public:
    void end_pass() { ++open_; }
    bool full() const;
    void close();

    std::size_t half() const;  ///< of the passes since the last batch
    std::uint64_t open_passes() const { return open_; }
    std::uint64_t passes(std::size_t half) const { return passes_[half]; }  ///< in closed batches
    /// Of them, those of the half's first batch, which tell nothing of its variance.
    std::uint64_t first_passes(std::size_t half) const { return first_[half]; }

    /// Throws StateError if what is restored is no such state.
    void state(StateArchive& archive);

  private:
    std::uint64_t batches_ = 0, open_ = 0;
    std::array<std::uint64_t, 2> passes_{}, first_{};
};

/// Means of both halves of the passes that a film holds, up to the last batch: it keeps
/// the sums of all then, and of the first half's; the second's are the rest. 32 bytes a pixel, 64
/// where passes have two parts.
class HalfMeans {
  public:
    explicit HalfMeans(std::size_t pixels) : sums_(pixels) {}

    /// Means of a pixel as they are now.
    using Means = std::function<PixelMeans(std::size_t)>;
    /// With a second part or without, as the passes so far have had one.
    void end_batch(const Means& means, bool has_second, std::size_t half);
    void end_batch(const FilmAccumulator& film, std::size_t half) {
        end_batch([&film](std::size_t i) { return film.means(i); }, film.has_second(), half);
    }
    /// Of the pixel, both parts summed; 0 where the half has no samples.
    Imath::V3d mean(std::size_t half, std::size_t pixel) const;
    void clear();

    /// Throws StateError if what is restored is no possible state.
    void state(StateArchive& archive);
    std::size_t memory_bytes() const;

  private:
    /// Of weight times radiance, and of weights.
    struct Sum {
        std::array<float, 3> color{};
        float weight = 0;
    };
    /// Of one part of the passes.
    struct Sums {
        Sum all, first_half;
    };
    static void add(Sums& sums, const PixelMeans& now, std::size_t part, std::size_t half);
    static Imath::V3d mean(const Sums& sums, std::size_t half);

    std::vector<Sums> sums_;
    std::vector<Sums> second_;  ///< empty without a second part
};

}  // namespace lxs
