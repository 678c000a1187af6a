// Which pixels around are averaged with a pixel.
//
// Row by row and one displacement after the other, so that inner loops run along a row over plain
// arrays: compilers turn them into vector instructions, and a pixel's sums have a fixed order.
#include "neighbours.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "constants.h"

namespace lxs::denoising {
namespace {

constexpr float kTiny = 1e-20f;  // keeps 0 / 0 out where both pixels have no noise

/// By which pixels of a row are compared with others.
struct Displacement {
    int dx, dy;
};

/// Squared difference beyond what noise explains, in units of that noise: about 0 for pixels that
/// are one, below 0 where they happen to agree. Of the other's variance no more than the own is
/// taken off, so that a noisy pixel doesn't pass for everything (Rousselle et al. 2012, eq. 8).
inline float distance(float a, float b, float variance_a, float variance_b, float tolerance,
                      float least) {
    const float difference = a - b;
    const float both = variance_a + variance_b;
    const float explained = variance_a + std::min(variance_a, variance_b);
    return (difference * difference - explained) / (tolerance * std::max(both, least) + kTiny);
}

/// Close to exp(-d), but 0 from 4 on, and the same bits on every machine.
inline float weight_at(float d) {
    const float t = std::max(1 - std::max(d, 0.0f) * 0.25f, 0.0f);
    return t * t * t * t;
}

/// Averages one row of pixels.
class RowAverage {
  public:
    RowAverage(const Judge& judge, const Colors& image, std::uint32_t y)
        : judge_(judge),
          image_(image),
          width_(static_cast<int>(judge.size.width)),
          y_(static_cast<int>(y)),
          distances_(judge.size.width),
          weights_(judge.size.width),
          total_(judge.size.width) {
        for (Plane& sum : sums_)
            sum.resize(judge.size.width);
    }

    void run() {
        const int last = static_cast<int>(judge_.size.height) - 1;
        for (int dy = std::max(-kReach, -y_); dy <= std::min(kReach, last - y_); ++dy) {
            for (int dx = std::max(-kReach, 1 - width_); dx <= std::min(kReach, width_ - 1); ++dx)
                add({dx, dy});
        }
    }

    void store(Colors& out) const {
        for (std::size_t c = 0; c < out.size(); ++c) {
            float* const row = &out[c][at(y_)];
            for (std::size_t x = 0; x < total_.size(); ++x)
                row[x] = sums_[c][x] / total_[x];
        }
    }

  private:
    std::size_t at(int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    }

    void add(Displacement by) {
        begin_ = std::max(0, -by.dx);
        end_ = width_ - std::max(0, by.dx);
        if (by.dx == 0 && by.dy == 0) {
            std::fill(weights_.begin(), weights_.end(), 1.0f);
        } else {
            weigh_colors(by);
            weigh_guides(by);
            weigh_noise(by);
        }
        for (int x = begin_; x < end_; ++x)
            total_[index(x)] += weights_[index(x)];
        for (std::size_t c = 0; c < sums_.size(); ++c) {
            const float* const others = &image_[c][at(y_ + by.dy)] + by.dx;
            for (int x = begin_; x < end_; ++x)
                sums_[c][index(x)] += weights_[index(x)] * others[x];
        }
    }

    static std::size_t index(int x) { return static_cast<std::size_t>(x); }

    /// By the mean distance over the surroundings of both pixels.
    void weigh_colors(Displacement by) {
        std::fill(distances_.begin(), distances_.end(), 0.0f);
        const int last = static_cast<int>(judge_.size.height) - 1;
        int rows = 0;
        for (int v = -kSurroundings; v <= kSurroundings; ++v) {
            const int y = y_ + v, other = y + by.dy;
            if (y < 0 || other < 0 || y > last || other > last) continue;
            ++rows;
            for (std::size_t c = 0; c < 3; ++c)
                add_distances(judge_.mean[c], judge_.variance[c], y, by);
        }
        for (int x = begin_; x < end_; ++x) {
            const int left = std::max(x - kSurroundings, begin_);
            const int right = std::min(x + kSurroundings, end_ - 1);
            float sum = 0;
            for (int u = left; u <= right; ++u)
                sum += distances_[index(u)];
            const int count = 3 * rows * (right - left + 1);
            weights_[index(x)] = weight_at(sum / static_cast<float>(count));
        }
    }

    void add_distances(const Plane& mean, const Plane& variance, int y, Displacement by) {
        const float* const a = &mean[at(y)];
        const float* const va = &variance[at(y)];
        const float* const b = &mean[at(y + by.dy)] + by.dx;
        const float* const vb = &variance[at(y + by.dy)] + by.dx;
        float* const sums = distances_.data();
        for (int x = begin_; x < end_; ++x)
            sums[x] += distance(a[x], b[x], va[x], vb[x], kColorTolerance, 0);
    }

    /// By the guide that tells the two pixels apart most surely.
    void weigh_guides(Displacement by) {
        if (judge_.guides->empty()) return;
        std::fill(distances_.begin(), distances_.end(), 0.0f);
        for (const Guide& guide : *judge_.guides) {
            const float* const a = &guide.value[at(y_)];
            const float* const va = &guide.variance[at(y_)];
            const float* const b = &guide.value[at(y_ + by.dy)] + by.dx;
            const float* const vb = &guide.variance[at(y_ + by.dy)] + by.dx;
            float* const most = distances_.data();
            for (int x = begin_; x < end_; ++x)
                most[x] = std::max(
                    most[x], distance(a[x], b[x], va[x], vb[x], kGuideTolerance, guide.least));
        }
        for (int x = begin_; x < end_; ++x)
            weights_[index(x)] *= weight_at(distances_[index(x)]);
    }

    /// A noisier pixel counts less, as in the best mean of two that are alike. The variance is that
    /// of the half that judges, and so is independent of what is averaged.
    void weigh_noise(Displacement by) {
        std::fill(distances_.begin(), distances_.end(), 1.0f);
        for (std::size_t c = 0; c < 3; ++c) {
            const float* const va = &judge_.variance[c][at(y_)];
            const float* const vb = &judge_.variance[c][at(y_ + by.dy)] + by.dx;
            float* const least = distances_.data();
            for (int x = begin_; x < end_; ++x)
                least[x] = std::min(least[x], (va[x] + kTiny) / (vb[x] + kTiny));
        }
        for (int x = begin_; x < end_; ++x)
            weights_[index(x)] *= distances_[index(x)];
    }

    const Judge& judge_;
    const Colors& image_;
    int width_, y_;
    int begin_ = 0, end_ = 0;  ///< pixels of the row that have another at the displacement
    std::vector<float> distances_, weights_, total_;
    Colors sums_;
};

}  // namespace

Colors average_alike(const Judge& judge, const Colors& image) {
    Colors out;
    for (Plane& plane : out)
        plane.resize(judge.size.pixels());
    tbb::parallel_for(std::uint32_t{0}, judge.size.height, [&](std::uint32_t y) {
        RowAverage row(judge, image, y);
        row.run();
        row.store(out);
    });
    return out;
}

}  // namespace lxs::denoising
