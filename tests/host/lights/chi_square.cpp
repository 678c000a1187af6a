// Chi-square test of counts against expected shares.
#include "chi_square.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

namespace lxs::test {

double chi_square_p(const std::vector<double>& counts, const std::vector<double>& shares,
                    int samples) {
    double statistic = 0, pooled_count = 0, pooled_expected = 0;
    int cells = 0;
    const auto add = [&](double count, double expected) {
        statistic += (count - expected) * (count - expected) / expected;
        ++cells;
    };
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double expected = shares[i] * samples;
        if (expected < 20) {
            pooled_count += counts[i];
            pooled_expected += expected;
        } else {
            add(counts[i], expected);
        }
    }
    if (pooled_expected >= 20) add(pooled_count, pooled_expected);
    EXPECT_LT(std::abs(pooled_count - pooled_expected), 60 + 0.1 * pooled_expected);
    const boost::math::chi_squared distribution(std::max(1, cells - 1));
    return boost::math::cdf(boost::math::complement(distribution, statistic));
}

double one_of(std::size_t tests) {
    return 1 - std::pow(0.99, 1.0 / static_cast<double>(tests));
}

}  // namespace lxs::test
