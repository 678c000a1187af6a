// Which pixels around are averaged with a pixel.
//
// A band of rows and one displacement after the other, so that inner loops run along rows of plain
// arrays: compilers turn them into vector instructions, and a pixel's sums have a fixed order.
#include "neighbours.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "constants.h"

namespace lxs::denoising {
namespace {

constexpr float kTiny = 1e-20f;  // keeps 0 / 0 out where both pixels have no noise

constexpr int kRows = 16;  // of a band: work of one task
constexpr int kMargin = kSurroundings;

/// By which pixels are compared with others.
struct Displacement {
    int dx, dy;
};

/// From `first` to before `end`.
struct Interval {
    int first, end;
    bool holds(int i) const { return first <= i && i < end; }
};

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

/// By value, unlike std::max, which compilers don't vectorize.
inline float larger(float a, float b) {
    return a < b ? b : a;
}
inline float lesser(float a, float b) {
    return b < a ? b : a;
}

/// Squared difference beyond what noise explains, in units of that noise: about 0 for pixels that
/// are one, below 0 where they happen to agree. Of the other's variance no more than the own is
/// taken off, so that a noisy pixel doesn't pass for everything (Rousselle et al. 2012, eq. 8).
inline float distance(float a, float b, float variance_a, float variance_b, float tolerance,
                      float least) {
    const float difference = a - b;
    const float both = variance_a + variance_b;
    const float explained = variance_a + lesser(variance_a, variance_b);
    return (difference * difference - explained) / (tolerance * larger(both, least) + kTiny);
}

/// Close to exp(-d), but 0 from 4 on, and the same bits on every machine.
inline float weight_at(float d) {
    const float t = larger(1 - larger(d, 0.0f) * 0.25f, 0.0f);
    return t * t * t * t;
}

/// Averages the pixels of some rows.
class BandAverage {
  public:
    BandAverage(const Judge& judge, const Colors& image, Interval rows)
        : judge_(judge),
          image_(image),
          width_(static_cast<int>(judge.size.width)),
          height_(static_cast<int>(judge.size.height)),
          rows_(rows),
          distances_(index(rows.end - rows.first + 2 * kMargin) * stride()),
          row_(stride()),
          weights_(index(width_)),
          total_(index(rows.end - rows.first) * index(width_)) {
        for (Plane& sum : sums_)
            sum.resize(total_.size());
    }

    void run() {
        const int reach_x = std::min(kReach, width_ - 1), reach_y = std::min(kReach, height_ - 1);
        for (int dy = -reach_y; dy <= reach_y; ++dy) {
            for (int dx = -reach_x; dx <= reach_x; ++dx)
                add({dx, dy});
        }
    }

    void store(Colors& out) const {
        for (std::size_t c = 0; c < out.size(); ++c) {
            float* const to = &out[c][at(rows_.first)];
            for (std::size_t i = 0; i < total_.size(); ++i)
                to[i] = sums_[c][i] / total_[i];
        }
    }

  private:
    std::size_t at(int y) const { return index(y) * index(width_); }
    std::size_t stride() const { return index(width_ + 2 * kMargin); }
    /// Distances of a row that is in the image, at its first pixel.
    float* distances(int y) {
        return &distances_[index(y - rows_.first + kMargin) * stride() + kMargin];
    }

    void add(Displacement by) {
        columns_ = {std::max(0, -by.dx), width_ - std::max(0, by.dx)};
        const Interval all{0, height_};
        for (int y = rows_.first - kMargin; y < rows_.end + kMargin; ++y) {
            if (all.holds(y) && all.holds(y + by.dy)) compare_colors(y, by);
        }
        for (int y = rows_.first; y < rows_.end; ++y) {
            if (all.holds(y + by.dy)) add_row(y, by);
        }
    }

    void add_row(int y, Displacement by) {
        if (by.dx == 0 && by.dy == 0) {
            std::fill(weights_.begin(), weights_.end(), 1.0f);
        } else {
            weigh_colors(y, by);
            weigh_guides(y, by);
            weigh_noise(y, by);
        }
        const float* const weights = weights_.data();
        float* const total = &total_[at(y - rows_.first)];
        for (int x = columns_.first; x < columns_.end; ++x)
            total[x] += weights[x];
        for (std::size_t c = 0; c < sums_.size(); ++c) {
            const float* const others = &image_[c][at(y + by.dy)] + by.dx;
            float* const sums = &sums_[c][at(y - rows_.first)];
            for (int x = columns_.first; x < columns_.end; ++x)
                sums[x] += weights[x] * others[x];
        }
    }

    /// Sum over colours of the distances of single pixels; 0 where there is no other.
    void compare_colors(int y, Displacement by) {
        float* const sums = distances(y);
        std::fill(sums - kMargin, sums + width_ + kMargin, 0.0f);
        for (std::size_t c = 0; c < 3; ++c) {
            const float* const a = &judge_.mean[c][at(y)];
            const float* const va = &judge_.variance[c][at(y)];
            const float* const b = &judge_.mean[c][at(y + by.dy)] + by.dx;
            const float* const vb = &judge_.variance[c][at(y + by.dy)] + by.dx;
            for (int x = columns_.first; x < columns_.end; ++x)
                sums[x] += distance(a[x], b[x], va[x], vb[x], kColorTolerance, 0);
        }
    }

    /// By the mean distance over the surroundings of both pixels.
    void weigh_colors(int y, Displacement by) {
        std::fill(row_.begin(), row_.end(), 0.0f);
        float* const sums = row_.data();
        const Interval all{0, height_};
        int rows = 0;
        for (int v = y - kSurroundings; v <= y + kSurroundings; ++v) {
            if (!all.holds(v) || !all.holds(v + by.dy)) continue;
            ++rows;
            for (int u = -kSurroundings; u <= kSurroundings; ++u) {
                const float* const row = distances(v) + u;
                for (int x = columns_.first; x < columns_.end; ++x)
                    sums[x] += row[x];
            }
        }
        const float inner = static_cast<float>(3 * rows * (2 * kSurroundings + 1));
        for (int x = columns_.first; x < columns_.end; ++x)
            weights_[index(x)] = weight_at(sums[x] / inner);
        const int edge = std::min(kSurroundings, columns_.end - columns_.first);
        for (int i = 0; i < edge; ++i) {
            for (const int x : {columns_.first + i, columns_.end - 1 - i}) {
                const int left = std::max(x - kSurroundings, columns_.first);
                const int right = std::min(x + kSurroundings, columns_.end - 1);
                const auto count = static_cast<float>(3 * rows * (right - left + 1));
                weights_[index(x)] = weight_at(sums[x] / count);
            }
        }
    }

    /// By the guide that tells the two pixels apart most surely.
    void weigh_guides(int y, Displacement by) {
        if (judge_.guides->empty()) return;
        std::fill(row_.begin(), row_.end(), 0.0f);
        float* const most = row_.data();
        for (const Guide& guide : *judge_.guides) {
            const float* const a = &guide.value[at(y)];
            const float* const va = &guide.variance[at(y)];
            const float* const b = &guide.value[at(y + by.dy)] + by.dx;
            const float* const vb = &guide.variance[at(y + by.dy)] + by.dx;
            const float least = guide.least;
            for (int x = columns_.first; x < columns_.end; ++x)
                most[x] =
                    larger(most[x], distance(a[x], b[x], va[x], vb[x], kGuideTolerance, least));
        }
        for (int x = columns_.first; x < columns_.end; ++x)
            weights_[index(x)] *= weight_at(most[x]);
    }

    /// A noisier pixel counts less, as in the best mean of two that are alike. The variance is that
    /// of the half that judges, and so is independent of what is averaged.
    void weigh_noise(int y, Displacement by) {
        std::fill(row_.begin(), row_.end(), 1.0f);
        float* const least = row_.data();
        for (std::size_t c = 0; c < 3; ++c) {
            const float* const va = &judge_.variance[c][at(y)];
            const float* const vb = &judge_.variance[c][at(y + by.dy)] + by.dx;
            for (int x = columns_.first; x < columns_.end; ++x)
                least[x] = lesser(least[x], (va[x] + kTiny) / (vb[x] + kTiny));
        }
        for (int x = columns_.first; x < columns_.end; ++x)
            weights_[index(x)] *= least[x];
    }

    const Judge& judge_;
    const Colors& image_;
    int width_, height_;
    Interval rows_;
    Interval columns_{0, 0};  ///< that have another pixel at the displacement
    Plane distances_;         ///< rows of `rows_` and around, with a margin at both ends
    Plane row_, weights_, total_;
    Colors sums_;
};

}  // namespace

Colors average_alike(const Judge& judge, const Colors& image) {
    Colors out;
    for (Plane& plane : out)
        plane.resize(judge.size.pixels());
    const int height = static_cast<int>(judge.size.height);
    tbb::parallel_for(0, (height + kRows - 1) / kRows, [&](int band) {
        const int first = band * kRows;
        BandAverage average(judge, image, {first, std::min(first + kRows, height)});
        average.run();
        average.store(out);
    });
    return out;
}

}  // namespace lxs::denoising
