// The samples of a pass by the pixel that they lie in.
#include "sample_cells.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace lxs {
namespace {

constexpr std::uint32_t kRefused = std::numeric_limits<std::uint32_t>::max();

bool acceptable(float value) {
    return value >= 0 && value <= std::numeric_limits<float>::max();  // false for NaN
}

bool acceptable(std::span<const Rgb> radiance) {
    return std::all_of(radiance.begin(), radiance.end(), [](const Rgb& c) {
        return acceptable(c.x) && acceptable(c.y) && acceptable(c.z);
    });
}

/// Samples and cells that one job takes.
constexpr std::size_t kSamplesPerJob = 4096, kCellsPerJob = std::size_t{1} << 15;

/// Calls work(first, last) for pieces of [0, count) on all threads.
template <class Work>
void in_pieces(std::size_t count, std::size_t size, const Work& work) {
    tbb::parallel_for(std::size_t{0}, (count + size - 1) / size, [&](std::size_t piece) {
        work(piece * size, std::min((piece + 1) * size, count));
    });
}

std::uint32_t cell_index(float position, std::uint32_t size) {
    return static_cast<std::uint32_t>(std::clamp(position, 0.0f, static_cast<float>(size - 1)));
}

bool is_weight(double weight) {
    return weight > 0 && std::isfinite(weight);
}

}  // namespace

SampleCells::SampleCells(std::uint32_t width, std::uint32_t height, std::uint32_t groups)
    : width_(width), height_(height), groups_(groups), refused_(std::size_t{groups} + 1) {}

void SampleCells::check(const PassSamples& pass) const {
    const std::size_t values = pass.positions.size() * groups_;
    const std::size_t second = pass.second_radiance.size();
    if (pass.groups != groups_ || pass.radiance.size() != values ||
        (second != values && second != 0)) {
        throw std::invalid_argument("film: radiance doesn't match positions and light groups");
    }
    if (!is_weight(pass.weight) || !is_weight(pass.second_weight)) {
        throw std::invalid_argument("film: the weight of a pass must be finite and positive");
    }
    if (pass.positions.size() >= kRefused) {
        throw std::invalid_argument("film: a pass has more than 2^32 - 2 samples");
    }
}

/// Of `count` values from the `first` one on, in both parts.
bool SampleCells::acceptable_radiance(const PassSamples& pass, std::size_t first,
                                      std::size_t count) const {
    return acceptable(pass.radiance.subspan(first, count)) &&
           (pass.second_radiance.empty() || acceptable(pass.second_radiance.subspan(first, count)));
}

void SampleCells::find_cells(const PassSamples& pass) {
    cell_of_sample_.resize(pass.positions.size());
    in_pieces(pass.positions.size(), kSamplesPerJob, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i != last; ++i) {
            const Vec2& p = pass.positions[i];
            const bool good = std::isfinite(p.x) && std::isfinite(p.y) &&
                              acceptable_radiance(pass, i * groups_, groups_);
            cell_of_sample_[i] =
                good ? cell_index(p.y, height_) * width_ + cell_index(p.x, width_) : kRefused;
        }
    });
}

/// Where ranges of samples begin that have no cell in common, and where the last ends. Samples that
/// come in the order of their pixels make up many, others one.
std::vector<std::size_t> SampleCells::ranges() const {
    struct Piece {
        std::uint32_t least = kRefused, greatest = 0;  // cell; then the greatest so far
    };
    const std::size_t samples = cell_of_sample_.size();
    std::vector<Piece> pieces((samples + kSamplesPerJob - 1) / kSamplesPerJob);
    in_pieces(samples, kSamplesPerJob, [&](std::size_t first, std::size_t last) {
        Piece& piece = pieces[first / kSamplesPerJob];
        for (std::size_t i = first; i != last; ++i) {
            if (cell_of_sample_[i] == kRefused) continue;
            piece.least = std::min(piece.least, cell_of_sample_[i]);
            piece.greatest = std::max(piece.greatest, cell_of_sample_[i]);
        }
    });
    for (std::size_t p = 1; p < pieces.size(); ++p)
        pieces[p].greatest = std::max(pieces[p].greatest, pieces[p - 1].greatest);
    std::vector<std::size_t> begins{samples};
    std::uint32_t least = kRefused;  // of the pieces behind
    for (std::size_t p = pieces.size(); p-- > 1;) {
        least = std::min(least, pieces[p].least);
        if (pieces[p - 1].greatest < least) begins.push_back(p * kSamplesPerJob);
    }
    begins.push_back(0);
    std::ranges::reverse(begins);
    return begins;
}

/// Counts the samples of each cell c, in cell_begin_[c + 2], and those that are refused.
void SampleCells::count(const PassSamples& pass, const std::vector<std::size_t>& begins) {
    std::atomic<bool> any_refused = false;
    tbb::parallel_for(std::size_t{1}, begins.size(), [&](std::size_t range) {
        for (std::size_t i = begins[range - 1]; i < begins[range]; ++i) {
            if (cell_of_sample_[i] == kRefused) {
                any_refused.store(true, std::memory_order_relaxed);
            } else {
                ++cell_begin_[cell_of_sample_[i] + 2];
            }
        }
    });
    if (!any_refused) return;
    for (std::size_t i = 0; i < cell_of_sample_.size(); ++i) {
        if (cell_of_sample_[i] == kRefused) ++refused_[reason_for_refusal(pass, i)];
    }
}

/// Makes places of counts: each becomes the sum of those up to it.
void SampleCells::sum_counts() {
    std::vector<std::uint32_t> sums((cell_begin_.size() + kCellsPerJob - 1) / kCellsPerJob);
    in_pieces(cell_begin_.size(), kCellsPerJob, [&](std::size_t first, std::size_t last) {
        std::uint32_t sum = 0;
        for (std::size_t c = first; c != last; ++c)
            sum = cell_begin_[c] += sum;
        sums[first / kCellsPerJob] = sum;
    });
    std::exclusive_scan(sums.begin(), sums.end(), sums.begin(), 0u);
    in_pieces(cell_begin_.size(), kCellsPerJob, [&](std::size_t first, std::size_t last) {
        for (std::size_t c = first; c != last; ++c)
            cell_begin_[c] += sums[first / kCellsPerJob];
    });
}

/// The first group whose radiance can't be taken, or the number of groups: its position can't.
std::size_t SampleCells::reason_for_refusal(const PassSamples& pass, std::size_t sample) const {
    for (std::size_t g = 0; g < groups_; ++g) {
        if (!acceptable_radiance(pass, sample * groups_ + g, 1)) return g;
    }
    return groups_;
}

void SampleCells::sort(const PassSamples& pass) {
    check(pass);
    find_cells(pass);
    // Stable counting sort; cell_begin_[c + 1] becomes the next free place of cell c.
    cell_begin_.resize(std::size_t{width_} * height_ + 2);
    in_pieces(cell_begin_.size(), kCellsPerJob, [&](std::size_t first, std::size_t last) {
        std::fill_n(cell_begin_.begin() + std::ptrdiff_t(first), last - first, 0u);
    });
    const std::vector<std::size_t> begins = ranges();
    count(pass, begins);
    sum_counts();
    order_.resize(cell_begin_.back());
    tbb::parallel_for(std::size_t{1}, begins.size(), [&](std::size_t range) {
        for (std::size_t i = begins[range - 1]; i < begins[range]; ++i) {
            if (cell_of_sample_[i] == kRefused) continue;
            order_[cell_begin_[cell_of_sample_[i] + 1]++] = std::uint32_t(i);
        }
    });
}

void SampleCells::state_of_refused(StateArchive& archive) {
    archive.fixed(refused_);
}

std::size_t SampleCells::memory_bytes() const {
    const std::size_t cells = std::size_t{width_} * height_;
    const std::size_t samples = std::max(cells, cell_of_sample_.capacity());
    return (cells + 2 + 2 * samples) * sizeof(std::uint32_t);
}

}  // namespace lxs
