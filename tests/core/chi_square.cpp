// Chi-square test.
#include "chi_square.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace aips::test {
namespace {

constexpr double kMinExpected = 5;

/// P(a, x) by its series, for x < a + 1 (Press et al., Numerical Recipes, 6.2).
double lower_gamma_series(double a, double x) {
    double term = 1 / a;
    double sum = term;
    for (double n = a + 1; term > sum * 1e-16; ++n) {
        term *= x / n;
        sum += term;
    }
    return sum * std::exp(-x + a * std::log(x) - std::lgamma(a));
}

/// Q(a, x) by its continued fraction (Lentz), for x >= a + 1.
double upper_gamma_fraction(double a, double x) {
    double b = x + 1 - a;
    double c = 1e300;
    double d = 1 / b;
    double h = d;
    for (int i = 1; i < 10000; ++i) {
        const double an = -i * (i - a);
        b += 2;
        d = 1 / (an * d + b);
        c = b + an / c;
        h *= d * c;
        if (std::abs(d * c - 1) < 1e-15) break;
    }
    return h * std::exp(-x + a * std::log(x) - std::lgamma(a));
}

}  // namespace

double chi_square_tail(double x, int degrees) {
    const double a = 0.5 * degrees;
    const double half = 0.5 * x;
    if (half <= 0) return 1;
    return half < a + 1 ? 1 - lower_gamma_series(a, half) : upper_gamma_fraction(a, half);
}

double sidak(double total, int tests) {
    return -std::expm1(std::log1p(-total) / tests);
}

ChiSquareResult chi_square(std::span<const double> observed, std::span<const double> expected) {
    std::vector<std::size_t> order(observed.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });
    ChiSquareResult result;
    double pooled_observed = 0, pooled_expected = 0, worst = 0;
    std::size_t worst_cell = 0;
    int pools = 0;
    for (const std::size_t cell : order) {
        if (expected[cell] == 0 && observed[cell] > 0) {
            result.p_value = 0;
            result.describe = "drew from impossible cell " + std::to_string(cell);
            return result;
        }
        pooled_observed += observed[cell];
        pooled_expected += expected[cell];
        if (pooled_expected < kMinExpected) continue;
        const double difference = pooled_observed - pooled_expected;
        const double share = difference * difference / pooled_expected;
        if (share > worst) {
            worst = share;
            worst_cell = cell;
        }
        result.statistic += share;
        ++pools;
        pooled_observed = pooled_expected = 0;
    }
    result.degrees = pools - 1;
    result.p_value = result.degrees > 0 ? chi_square_tail(result.statistic, result.degrees) : 1;
    result.describe = "chi2 " + std::to_string(result.statistic) + " with " +
                      std::to_string(result.degrees) + " degrees, p " +
                      std::to_string(result.p_value) + "; worst cell " +
                      std::to_string(worst_cell) + ": observed " +
                      std::to_string(observed.empty() ? 0.0 : observed[worst_cell]) +
                      ", expected " + std::to_string(expected.empty() ? 0.0 : expected[worst_cell]);
    return result;
}

}  // namespace aips::test
