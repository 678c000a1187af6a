// Pearson's chi-square test of counts against expected counts, with pooling of rare cells.
#pragma once

#include <span>
#include <string>

namespace aips::test {

struct ChiSquareResult {
    double statistic = 0;
    int degrees = 0;
    double p_value = 1;    ///< 0 when something drawn had an expected count of zero
    std::string describe;  ///< the figures, and the worst cell
};

/// Cells are pooled, rarest first, until each pool expects at least 5. The expected counts must sum
/// to the observed total.
ChiSquareResult chi_square(std::span<const double> observed, std::span<const double> expected);

/// Significance of one of `tests` tests so that all together reject wrongly with `total` (Sidak).
double sidak(double total, int tests);

/// Upper tail of the chi-square distribution: regularised incomplete gamma Q(degrees/2, x/2).
double chi_square_tail(double x, int degrees);

}  // namespace aips::test
