// A denoiser without training: a pixel is averaged with those around that its own noise can't tell
// from it.
#include "lxs/denoise/denoise.h"

#include <algorithm>
#include <cmath>

#include "constants.h"
#include "neighbours.h"
#include "planes.h"

namespace lxs {
namespace {

using namespace denoising;

struct Half {
    Colors mean, variance;
    Colors around;  ///< mean of the variances of 3 x 3 pixels
};

Half read_half(const HalfImage& image, Size size) {
    Half half{planes_of(image.mean), planes_of(image.variance), {}};
    for (std::size_t c = 0; c < 3; ++c) {
        for (float& v : half.variance[c])
            v = std::max(v, 0.0f);
        half.around[c] = mean_around(half.variance[c], size);
    }
    return half;
}

std::vector<Guide> read_guides(const NoisyImage& image, Size size) {
    std::vector<Guide> guides;
    for (const GuideChannel& channel : image.guides) {
        const Plane variance = mean_around(finite(channel.variance), size);
        guides.push_back({finite(channel.value), variance, channel.least});
    }
    return guides;
}

/// A bright path that one half alone has met stands far above what the other half knows, its noise
/// around included. With more passes both halves' means meet, and nothing is cut.
Colors without_excess(const Half& half, const Half& other) {
    Colors cut = half.mean;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < cut[c].size(); ++i) {
            const float most = other.mean[c][i] + kMostExcess * std::sqrt(other.around[c][i]);
            cut[c][i] = std::min(cut[c][i], most);
        }
    }
    return cut;
}

/// A variance from few passes is itself noisy: those around steady it. But beside what is bright
/// and noisy a dark pixel keeps to its own.
Colors steady_variance(const Half& half) {
    Colors variance = half.around;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < variance[c].size(); ++i)
            variance[c][i] = std::min(variance[c][i], kMostOfOwnVariance * half.variance[c][i]);
    }
    return variance;
}

}  // namespace

std::vector<Rgb> denoise(const NoisyImage& image) {
    const Size size{image.width, image.height};
    const std::array<Half, 2> halves{read_half(image.halves[0], size),
                                     read_half(image.halves[1], size)};
    const std::vector<Guide> guides = read_guides(image, size);
    const std::array<Colors, 2> cut{without_excess(halves[0], halves[1]),
                                    without_excess(halves[1], halves[0])};
    std::vector<Rgb> result(size.pixels(), Rgb(0.0f));
    const double passes = image.halves[0].passes + image.halves[1].passes;
    for (std::size_t h = 0; h < 2; ++h) {
        const Judge judge{size, cut[1 - h], steady_variance(halves[1 - h]), &guides};
        const Colors mean = average_alike(judge, cut[h]);
        const auto share = static_cast<float>(image.halves[h].passes / passes);
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] += Rgb(mean[0][i], mean[1][i], mean[2][i]) * share;
    }
    return result;
}

}  // namespace lxs
