// Are two renderers' images equal in expectation? Welch tests on block means over seeds, corrected
// for the number of blocks.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace statistics {

/// One sample of block means: [seed][block].
using BlockMeans = std::vector<std::vector<double>>;

struct Comparison {
    double smallest_p = 1;  ///< over the blocks and the mean of all blocks
    double threshold = 0;   ///< Sidak-corrected significance a single test must fall below
    std::size_t tests = 0;
    std::size_t smallest_at = 0;    ///< block of the smallest p; tests - 1: the mean of all
    double mean_ratio = 0;          ///< mean of b over mean of a
    double standard_error = 0;      ///< of the difference of the means, relative to the mean of a
    double degrees_of_freedom = 0;  ///< of that error; 0 without spread
    /// Relative difference of the whole image's mean that would be found with 90 % probability.
    double detectable = 0;
    /// The same of the median block, among those that have any light.
    double detectable_in_block = 0;
    bool differs() const { return smallest_p < threshold; }
    std::string describe() const;
};

/// Compares a and b (each at least 3 seeds of equally many blocks) at family-wise `significance`.
/// Blocks without spread and without difference are skipped. A difference counts only beyond
/// `allowed`, a known relative bias of b, in each block and in the mean. `weights` are those of a's
/// seeds, whose variance goes with 1 / weight; none: all are equal.
Comparison compare(const BlockMeans& a, const BlockMeans& b, double significance,
                   double allowed = 0, const std::vector<double>& weights = {});

/// The same for renders made in pairs of one seed, of which a large part is equal by construction
/// (eye paths, shadow rays, photons' first surfaces): t-tests of the differences within the pairs.
Comparison compare_paired(const BlockMeans& a, const BlockMeans& b, double significance);

/// Some of the blocks alone: a region of the image.
BlockMeans select(const BlockMeans& means, const std::vector<std::size_t>& blocks);

/// Mean over blocks of the variance over seeds (at least two).
double mean_variance(const BlockMeans& means);

/// All values times `factor`: a planted bias, to show that a comparison would find it.
BlockMeans scaled(BlockMeans means, double factor);

/// Values of several scenes, `values` of each, relative to the mean of its scene's last in
/// `reference`: a mean over all of them then weighs the scenes alike.
BlockMeans relative_to(const BlockMeans& reference, BlockMeans means, std::size_t values);

/// Two-sided p of Student's t with `degrees` (> 0, any real) of freedom.
double student_p(double t, double degrees);

/// What |t| of Student's t with `degrees` (> 0, any real) of freedom stays below with probability
/// `confidence`, in (0, 1).
double student_interval(double confidence, double degrees);

/// Means of size x size blocks of a width x height image of luminances.
std::vector<double> block_means(const std::vector<double>& luminance, std::size_t width,
                                std::size_t height, std::size_t size);

/// Median over the blocks of |a / b - 1|: a's relative difference from b, equally many blocks.
double median_difference(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace statistics
