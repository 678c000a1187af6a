// Chi-square test of counts against expected shares.
#pragma once

#include <vector>

namespace lxs::test {

/// p value of `counts` of `samples` draws against `shares`, the last cell being for all that fell
/// elsewhere. Cells that expect fewer than 20 are pooled, and the pool is expected to hold the
/// error of integrated shares too, up to a few in `samples`.
double chi_square_p(const std::vector<double>& counts, const std::vector<double>& shares,
                    int samples);

/// Significance of one of `tests` tests whose family is at 1 % (Sidak).
double one_of(std::size_t tests);

}  // namespace lxs::test
