// Pixels below zero, settled with the light around them.
#include "negative_lobes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

namespace lxs {
namespace {

/// A pixel below zero.
struct Deficit {
    std::size_t pixel;
    double owed;       ///< what is missing to zero, > 0
    double amount;     ///< of that, still missing
    double claim = 0;  ///< part of what its neighbours have that it asks for, in [0, 1]
};

/// The deficits of one channel. In each round every deficit is claimed of all pixels around it
/// alike; the sums are taken per pixel in a fixed order.
class Settlement {
  public:
    Settlement(const FilteredImage& image, int channel) : image_(image), channel_(channel) {
        for (std::size_t i = 0; i < image_.pixels.size(); ++i) {
            float& v = value(i);
            if (!(v < 0)) continue;
            deficits_.push_back({.pixel = i, .owed = -double{v}, .amount = -double{v}});
            v = 0;
        }
        if (!deficits_.empty()) claimed_.resize(image_.pixels.size());
    }

    void run() {
        constexpr int kRounds = 8;  // what is left then is owed where there is next to no light
        for (int round = 0; round < kRounds && !deficits_.empty(); ++round)
            settle(round < kRounds / 2 ? 1 : 2);
    }

  private:
    float& value(std::size_t pixel) const { return image_.pixels[pixel][channel_]; }

    /// Calls `visit` with each pixel that is no farther from `pixel` than `reach` times the
    /// filter's reach, row by row.
    template <class Visit>
    void around(std::size_t pixel, std::uint32_t reach, const Visit& visit) const {
        const auto y = static_cast<std::uint32_t>(pixel / image_.width);
        const auto x = static_cast<std::uint32_t>(pixel % image_.width);
        const std::uint32_t dx = reach * image_.reach_x, dy = reach * image_.reach_y;
        const std::uint32_t left = x - std::min(x, dx), top = y - std::min(y, dy);
        const std::uint32_t right = std::min(x + dx, image_.width - 1);
        const std::uint32_t bottom = std::min(y + dy, image_.height - 1);
        for (std::uint32_t row = top; row <= bottom; ++row) {
            const std::size_t begin = std::size_t{row} * image_.width;
            for (std::size_t i = begin + left; i <= begin + right; ++i)
                visit(i);
        }
    }

    template <class Work>
    void for_deficits(const Work& work) {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, deficits_.size(), 64),
                          [&](const auto& range) {
                              for (std::size_t i = range.begin(); i != range.end(); ++i)
                                  work(deficits_[i]);
                          });
    }

    void settle(std::uint32_t reach) {
        for_deficits([&](Deficit& deficit) {
            double light = 0;
            around(deficit.pixel, reach, [&](std::size_t i) { light += value(i); });
            deficit.claim = light > deficit.amount ? deficit.amount / light : light > 0 ? 1 : 0;
        });
        for (const Deficit& deficit : deficits_)
            around(deficit.pixel, reach, [&](std::size_t i) { claimed_[i] += deficit.claim; });
        for_deficits([&](Deficit& deficit) {
            double taken = 0;
            around(deficit.pixel, reach, [&](std::size_t i) {
                taken += value(i) * deficit.claim / std::max(claimed_[i], 1.0);
            });
            deficit.amount -= taken;
        });
        tbb::parallel_for(std::size_t{0}, claimed_.size(), [&](std::size_t i) {
            if (claimed_[i] == 0) return;
            value(i) = static_cast<float>(value(i) * std::max(0.0, 1 - claimed_[i]));
            claimed_[i] = 0;
        });
        std::erase_if(deficits_, [](const Deficit& deficit) {
            constexpr double kRounding = 1e-9;
            return deficit.amount <= kRounding * deficit.owed;
        });
    }

    const FilteredImage& image_;
    int channel_;
    std::vector<Deficit> deficits_;  ///< row by row
    /// Per pixel, what all deficits claim of it in this round, as part of what it has.
    std::vector<double> claimed_;
};

}  // namespace

void redistribute_negative_lobes(const FilteredImage& image) {
    for (int channel = 0; channel < 3; ++channel)
        Settlement(image, channel).run();
}

}  // namespace lxs
