// Can a scene's references be trusted? Agreement of the two, and the bias that their radius leaves.
#include "reference_checks.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>

namespace bench {
namespace {

namespace algo = OIIO::ImageBufAlgo;

/// First pixel of block `index` of `size` pixels.
int edge(int index, int size) {
    return index * size / kBlocksPerSide;
}

}  // namespace

statistics::BlockMeans chunk_blocks(const Json& chunks) {
    statistics::BlockMeans means;
    for (const Json& chunk : chunks)
        means.push_back(chunk.at("blocks").get<std::vector<double>>());
    return means;
}

std::vector<double> block_luminances(const Image& image) {
    const OIIO::ROI all = image.roi();
    std::vector<double> means;
    for (int row = 0; row < kBlocksPerSide; ++row) {
        for (int column = 0; column < kBlocksPerSide; ++column) {
            const int x = all.xbegin + edge(column, all.width());
            const int y = all.ybegin + edge(row, all.height());
            const int right = all.xbegin + edge(column + 1, all.width());
            const int bottom = all.ybegin + edge(row + 1, all.height());
            const OIIO::ROI block(x, std::max(x + 1, right), y, std::max(y + 1, bottom), 0, 1, 0,
                                  3);
            means.push_back(mean_luminance(algo::cut(image, block)));
        }
    }
    return means;
}

Json agreement(const Json& images) {
    for (const char* name : kReferenceNames) {
        if (!images.contains(name) || images.at(name).at("chunks").size() < 3) return nullptr;
    }
    const auto comparison = statistics::compare(
        chunk_blocks(images.at(kReferenceNames[0]).at("chunks")),
        chunk_blocks(images.at(kReferenceNames[1]).at("chunks")), kDisagreement);
    return {{"agree", !comparison.differs()},
            {"mean_ratio", comparison.mean_ratio},
            {"smallest_p", comparison.smallest_p},
            {"threshold", comparison.threshold},
            {"detectable", comparison.detectable}};
}

Json bias_left(const ReferencePair& references, const WeightedImage& halved) {
    const auto& [first, second] = references;
    const Image error = standard_error(halved);
    const Image noise = algo::mul(error, error);
    const Image product = error_product(halved.mean, first, second);
    const double epsilon = relative_epsilon(first, second);
    const double mean = (mean_luminance(first) + mean_luminance(second)) / 2;
    return {{"relmse", mean_value(relative_to(algo::sub(product, noise), first, second, epsilon))},
            {"mean_ratio", mean > 0 ? Json(mean_luminance(halved.mean) / mean) : Json()}};
}

Json relative_standard_error(const WeightedImage& image) {
    const double luminance = mean_luminance(image.mean);
    if (image.chunks < 2 || !(luminance > 0)) return nullptr;
    const Image error = standard_error(image);
    return std::sqrt(mean_value(algo::mul(error, error))) / luminance;
}

}  // namespace bench
