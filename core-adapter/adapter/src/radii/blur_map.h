// Which pixels gather discs blur more than noise disturbs them, and how much narrower that makes
// their discs.
#pragma once

#include <cstdint>
#include <vector>

#include "aips/core/base/state_archive.h"

namespace aips {

/// What a gather disc told of the light around a visible point in a pass, in any unit that is the
/// same for all of a pixel's.
struct DiscDensities {
    double whole = 0;     ///< density of contributions in the disc
    double half = 0;      ///< and in the inner half of its area
    double variance = 0;  ///< of the first, and of their difference, if photons came one by one
};

/// Judges the blur by what whole discs and their inner halves differ by. To leading order a disc's
/// bias goes with its area, so the whole one's is twice the difference.
class BlurMap {
  public:
    explicit BlurMap(std::size_t pixels);

    /// Takes note of a visible point of the pass. Points of different pixels may be added at once.
    void add(std::uint32_t pixel, const DiscDensities& densities);
    /// Judges the pixels that had points in the pass, on all threads. What is not finite is left
    /// out.
    void end_pass();
    /// Factor of a pixel's radii, [kLeastNarrowing, 1]: by at most kNarrowingStep less after each
    /// pass, and more again where noise is what is left.
    float narrowing(std::uint32_t pixel) const { return pixels_[pixel].narrowing; }

    /// Saves the sums, or restores them into a new map of the same size.
    void state(StateArchive& archive);

    std::size_t memory_bytes() const { return pixels_.capacity() * sizeof(Pixel); }
    static std::size_t memory_bound_bytes(std::size_t pixels) { return pixels * sizeof(Pixel); }

  private:
    struct Weights;

    /// Sums over passes, each of which takes a share from those before, and what this one brings.
    struct Pixel {
        double difference = 0;  // whole less half
        double squares = 0;     // of these
        double variance = 0;    // of the sum, by single photons
        float of_pass = 0;      // differences, summed over its visible points
        float variance_of_pass = 0;
        std::uint32_t points = 0;  // of this pass
        std::uint32_t passes = 0;  // with visible points, the last 2^32 - 1
        float narrowing = 1;

        void end_pass();
        double noise(const Weights& weights) const;
        void judge(double now);
    };

    std::vector<Pixel> pixels_;
};

}  // namespace aips
