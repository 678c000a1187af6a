// Welch tests on block means.
#include "block_test.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <sstream>

namespace statistics {
namespace {

struct Moments {
    double mean = 0, variance_of_mean = 0;
    double count = 0;
};

template <class Value>
Moments moments(std::size_t count, Value&& value) {
    Moments m;
    m.count = double(count);
    for (std::size_t i = 0; i < count; ++i)
        m.mean += value(i) / m.count;
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i)
        squares += (value(i) - m.mean) * (value(i) - m.mean);
    m.variance_of_mean = squares / (m.count - 1) / m.count;
    return m;
}

/// Welch-Satterthwaite degrees of freedom.
double degrees(const Moments& a, const Moments& b) {
    const double sum = a.variance_of_mean + b.variance_of_mean;
    return sum * sum /
           (a.variance_of_mean * a.variance_of_mean / (a.count - 1) +
            b.variance_of_mean * b.variance_of_mean / (b.count - 1));
}

double welch_p(const Moments& a, const Moments& b) {
    const double variance = a.variance_of_mean + b.variance_of_mean;
    const double difference = b.mean - a.mean;
    if (variance <= 0) return std::abs(difference) <= 1e-6 * std::abs(a.mean) ? 1 : 0;
    return student_p(difference / std::sqrt(variance), degrees(a, b));
}

double mean_of(const std::vector<double>& blocks) {
    double sum = 0;
    for (const double b : blocks)
        sum += b;
    return sum / double(blocks.size());
}

}  // namespace

double student_p(double t, double degrees_of_freedom) {
    const boost::math::students_t distribution(degrees_of_freedom);
    return 2 * cdf(complement(distribution, std::abs(t)));
}

Comparison compare(const BlockMeans& a, const BlockMeans& b, double significance) {
    Comparison result;
    const std::size_t blocks = a.front().size();
    result.tests = blocks + 1;
    result.threshold = 1 - std::pow(1 - significance, 1.0 / double(result.tests));
    for (std::size_t k = 0; k < blocks; ++k) {
        const Moments ma = moments(a.size(), [&](std::size_t i) { return a[i][k]; });
        const Moments mb = moments(b.size(), [&](std::size_t i) { return b[i][k]; });
        result.smallest_p = std::min(result.smallest_p, welch_p(ma, mb));
    }
    const Moments ma = moments(a.size(), [&](std::size_t i) { return mean_of(a[i]); });
    const Moments mb = moments(b.size(), [&](std::size_t i) { return mean_of(b[i]); });
    result.smallest_p = std::min(result.smallest_p, welch_p(ma, mb));
    result.mean_ratio = mb.mean / ma.mean;
    const boost::math::students_t t(std::max(1.0, degrees(ma, mb)));
    const double critical = quantile(complement(t, result.threshold / 2)) + quantile(t, 0.9);
    result.detectable =
        critical * std::sqrt(ma.variance_of_mean + mb.variance_of_mean) / std::abs(ma.mean);
    return result;
}

std::string Comparison::describe() const {
    std::ostringstream out;
    out << "mean ratio " << mean_ratio << ", smallest p " << smallest_p << " of " << tests
        << " tests (threshold " << threshold << "), detectable difference of the mean "
        << 100 * detectable << " %";
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

}  // namespace statistics
