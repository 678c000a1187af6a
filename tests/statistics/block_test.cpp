// Welch tests on block means.
#include "block_test.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace statistics {
namespace {

struct Moments {
    double mean = 0, variance_of_mean = 0;
    double count = 0;
};

/// `weights` go with 1 / variance; none: all are equal.
template <class Value>
Moments moments(std::size_t count, Value&& value, const std::vector<double>& weights = {}) {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    const auto share = [&](std::size_t i) {
        return weights.empty() ? 1 / double(count) : weights[i] / sum;
    };
    Moments m;
    m.count = double(count);
    for (std::size_t i = 0; i < count; ++i)
        m.mean += value(i) * share(i);
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i)
        squares += (value(i) - m.mean) * (value(i) - m.mean) * share(i);
    m.variance_of_mean = squares / (m.count - 1);
    return m;
}

/// Welch-Satterthwaite degrees of freedom.
double degrees(const Moments& a, const Moments& b) {
    const double sum = a.variance_of_mean + b.variance_of_mean;
    return sum * sum /
           (a.variance_of_mean * a.variance_of_mean / (a.count - 1) +
            b.variance_of_mean * b.variance_of_mean / (b.count - 1));
}

double welch_p(const Moments& a, const Moments& b, double allowed) {
    const double variance = a.variance_of_mean + b.variance_of_mean;
    const double difference = std::max(0.0, std::abs(b.mean - a.mean) - allowed * std::abs(a.mean));
    if (variance <= 0) return difference <= 1e-6 * std::abs(a.mean) ? 1 : 0;
    return student_p(difference / std::sqrt(variance), degrees(a, b));
}

/// Relative difference of means around `mean` that a test at significance `threshold` finds with
/// 90 % probability.
double detectable(double mean, double variance, double degrees, double threshold) {
    if (variance <= 0) return mean != 0 ? 0 : std::numeric_limits<double>::infinity();
    const boost::math::students_t t(std::max(1.0, degrees));
    const double critical = quantile(complement(t, threshold / 2)) + quantile(t, 0.9);
    return critical * std::sqrt(variance) / std::abs(mean);
}

/// What one test says.
struct Verdict {
    double p = 1, ratio = 1, detectable = 0;
    double standard_error = 0;  ///< of the difference, relative to a
    double degrees_of_freedom = 0;
};

double mean_of(const std::vector<double>& blocks) {
    double sum = 0;
    for (const double b : blocks)
        sum += b;
    return sum / double(blocks.size());
}

void note_p(double p, std::size_t at, Comparison& result) {
    if (p >= result.smallest_p) return;
    result.smallest_p = p;
    result.smallest_at = at;
}

/// One test a block, one of the mean of all; `test` takes what it looks at and the threshold.
template <class Test>
Comparison all_tests(std::size_t blocks, double significance, Test&& test) {
    Comparison result;
    result.tests = blocks + 1;
    result.threshold = 1 - std::pow(1 - significance, 1.0 / double(result.tests));
    std::vector<double> in_blocks;
    for (std::size_t k = 0; k < blocks; ++k) {
        const Verdict v =
            test([&](const std::vector<double>& means) { return means[k]; }, result.threshold);
        note_p(v.p, k, result);
        if (std::isfinite(v.detectable)) in_blocks.push_back(v.detectable);
    }
    std::sort(in_blocks.begin(), in_blocks.end());
    if (!in_blocks.empty()) result.detectable_in_block = in_blocks[in_blocks.size() / 2];
    const Verdict v = test(mean_of, result.threshold);
    note_p(v.p, blocks, result);
    result.mean_ratio = v.ratio;
    result.standard_error = v.standard_error;
    result.degrees_of_freedom = v.degrees_of_freedom;
    result.detectable = v.detectable;
    return result;
}

}  // namespace

double student_p(double t, double degrees_of_freedom) {
    const boost::math::students_t distribution(degrees_of_freedom);
    return 2 * cdf(complement(distribution, std::abs(t)));
}

double student_interval(double confidence, double degrees_of_freedom) {
    const boost::math::students_t distribution(degrees_of_freedom);
    return quantile(complement(distribution, (1 - confidence) / 2));
}

Comparison compare(const BlockMeans& a, const BlockMeans& b, double significance, double allowed,
                   const std::vector<double>& weights) {
    return all_tests(a.front().size(), significance, [&](auto&& value, double threshold) {
        const Moments ma = moments(
            a.size(), [&](std::size_t i) { return value(a[i]); }, weights);
        const Moments mb = moments(b.size(), [&](std::size_t i) { return value(b[i]); });
        const double variance = ma.variance_of_mean + mb.variance_of_mean;
        return Verdict{welch_p(ma, mb, allowed), mb.mean / ma.mean,
                       allowed + detectable(ma.mean, variance, degrees(ma, mb), threshold),
                       std::sqrt(variance) / std::abs(ma.mean), variance > 0 ? degrees(ma, mb) : 0};
    });
}

Comparison compare_paired(const BlockMeans& a, const BlockMeans& b, double significance) {
    return all_tests(a.front().size(), significance, [&](auto&& value, double threshold) {
        const Moments ma = moments(a.size(), [&](std::size_t i) { return value(a[i]); });
        const Moments difference =
            moments(a.size(), [&](std::size_t i) { return value(b[i]) - value(a[i]); });
        const double free = difference.count - 1, variance = difference.variance_of_mean;
        const double p = variance > 0
                             ? student_p(difference.mean / std::sqrt(variance), free)
                             : (std::abs(difference.mean) <= 1e-6 * std::abs(ma.mean) ? 1 : 0);
        return Verdict{p, 1 + difference.mean / ma.mean,
                       detectable(ma.mean, variance, free, threshold),
                       std::sqrt(variance) / std::abs(ma.mean), variance > 0 ? free : 0};
    });
}

BlockMeans select(const BlockMeans& means, const std::vector<std::size_t>& blocks) {
    BlockMeans selected(means.size());
    for (std::size_t i = 0; i < means.size(); ++i) {
        for (const std::size_t k : blocks)
            selected[i].push_back(means[i][k]);
    }
    return selected;
}

double mean_variance(const BlockMeans& means) {
    const auto seeds = double(means.size());
    double variance = 0;
    for (std::size_t block = 0; block < means[0].size(); ++block) {
        double mean = 0, squares = 0;
        for (const auto& seed : means)
            mean += seed[block] / seeds;
        for (const auto& seed : means)
            squares += (seed[block] - mean) * (seed[block] - mean);
        variance += squares / (seeds - 1);
    }
    return variance / double(means[0].size());
}

BlockMeans scaled(BlockMeans means, double factor) {
    for (auto& blocks : means) {
        for (double& block : blocks)
            block *= factor;
    }
    return means;
}

BlockMeans relative_to(const BlockMeans& reference, BlockMeans means, std::size_t values) {
    for (std::size_t i = 0; i < means.front().size(); ++i) {
        double sum = 0;
        for (const auto& seed : reference)
            sum += seed[i / values * values + values - 1];
        for (auto& seed : means)
            seed[i] /= sum / double(reference.size());
    }
    return means;
}

std::string Comparison::describe() const {
    std::ostringstream out;
    out << "mean ratio " << mean_ratio << ", smallest p " << smallest_p << " of " << tests
        << " tests (threshold " << threshold << "), detectable difference of the mean "
        << 100 * detectable << " %, of the median block " << 100 * detectable_in_block << " %";
    return out.str();
}

std::vector<double> block_means(const std::vector<double>& luminance, std::size_t width,
                                std::size_t height, std::size_t size) {
    std::vector<double> means;
    for (std::size_t y = 0; y + size <= height; y += size) {
        for (std::size_t x = 0; x + size <= width; x += size) {
            double sum = 0;
            for (std::size_t j = y; j < y + size; ++j) {
                for (std::size_t i = x; i < x + size; ++i)
                    sum += luminance[j * width + i];
            }
            means.push_back(sum / double(size * size));
        }
    }
    return means;
}

double median_difference(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.size(); ++i)
        differences.push_back(std::abs(a[i] / b[i] - 1));
    const auto middle = differences.begin() + std::ptrdiff_t(differences.size() / 2);
    std::nth_element(differences.begin(), middle, differences.end());
    return *middle;
}

}  // namespace statistics
