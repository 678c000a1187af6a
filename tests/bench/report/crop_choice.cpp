// Which part of a scene's images a report magnifies.
#include "crop_choice.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cstdlib>

namespace bench {
namespace {

constexpr int kSmallestSide = 24;
/// Places tried along each side of a crop's own length.
constexpr int kStepsPerCrop = 8;

Crop whole(const Image& image) {
    return {0, 0, image.spec().width, image.spec().height};
}

/// Of a small image no more than three fifths, or there would be nothing to choose.
int side_of_crop(int wanted, int whole) {
    return std::min(wanted, std::max(whole * 3 / 5, std::min(whole, kSmallestSide)));
}

/// Sums over the rectangle from the top left to each pixel (Crow 1984), with a row and a column of
/// zeros before.
class SummedTable {
  public:
    SummedTable(int width, int height)
        : stride_(std::size_t(width) + 1), sums_(stride_ * (std::size_t(height) + 1)) {}

    /// In order of rows, then columns.
    void set(int x, int y, double value) {
        at(x + 1, y + 1) = value + at(x, y + 1) + at(x + 1, y) - at(x, y);
    }
    double sum(const Crop& crop) {
        const int right = crop.x + crop.width_px, bottom = crop.y + crop.height_px;
        return at(right, bottom) - at(crop.x, bottom) - at(right, crop.y) + at(crop.x, crop.y);
    }

  private:
    double& at(int x, int y) { return sums_[std::size_t(y) * stride_ + std::size_t(x)]; }
    std::size_t stride_;
    std::vector<double> sums_;
};

SummedTable shown_differences(std::span<const Image* const> images, const Image& truth,
                              const ToneMap& map) {
    const Crop all = whole(truth);
    const DisplayImage expected = tone_map(truth, map, all);
    std::vector<double> sums(expected.pixels.size());
    for (const Image* image : images) {
        const DisplayImage shown = tone_map(*image, map, all);
        for (std::size_t i = 0; i < sums.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c)
                sums[i] += std::abs(int(shown.pixels[i][c]) - int(expected.pixels[i][c]));
        }
    }
    SummedTable table(all.width_px, all.height_px);
    for (int y = 0; y < all.height_px; ++y) {
        for (int x = 0; x < all.width_px; ++x)
            table.set(x, y, sums[std::size_t(y) * std::size_t(all.width_px) + std::size_t(x)]);
    }
    return table;
}

}  // namespace

Crop choose_crop(std::span<const Image* const> images, const Image& truth, const ToneMap& map,
                 const CropSize& size) {
    const Crop all = whole(truth);
    Crop crop{0, 0, side_of_crop(size.width_px, all.width_px),
              side_of_crop(size.height_px, all.height_px)};
    SummedTable table = shown_differences(images, truth, map);
    const int step = std::max(1, crop.height_px / kStepsPerCrop);
    Crop best = crop;
    double largest = -1;
    for (crop.y = 0; crop.y + crop.height_px <= all.height_px; crop.y += step) {
        for (crop.x = 0; crop.x + crop.width_px <= all.width_px; crop.x += step) {
            const double sum = table.sum(crop);
            if (sum <= largest) continue;
            largest = sum;
            best = crop;
        }
    }
    return best;
}

DisplayImage overview(const Image& image, const ToneMap& map) {
    const Crop all = whole(image);
    if (all.width_px <= kOverviewWidth) return tone_map(image, map, all);
    const int height = std::max(1, all.height_px * kOverviewWidth / all.width_px);
    const Image small = OIIO::ImageBufAlgo::resize(
        image, "box", 0, OIIO::ROI(0, kOverviewWidth, 0, height, 0, 1, 0, 3));
    return tone_map(small, map, {0, 0, kOverviewWidth, height});
}

}  // namespace bench
