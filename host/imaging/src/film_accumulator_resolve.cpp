// What the sums of a film say: the image, and the means that it is the sum of.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "dark_beside_bright.h"
#include "film_accumulator.h"
#include "finite_float.h"

namespace lxs {
namespace {

/// Sums R, G, B of light groups.
Imath::V3d sum_over(const double* sums, LightGroups groups) {
    Imath::V3d sum(0.0);
    for (std::size_t g = groups.first; g < groups.end; ++g)
        sum += Imath::V3d(sums[3 * g], sums[3 * g + 1], sums[3 * g + 2]);
    return sum;
}

/// What is below zero because RGB doesn't hold the colour of a spectrum, or because a film was
/// restored from a forged file, is nobody's deficit: it ends at zero. Negative lobes, where the
/// filter has some, are told by a luminance below zero.
void cut_below_zero(std::span<Rgb> image, bool lobes) {
    for (Rgb& c : image) {
        if (lobes && luminance(c) < 0) continue;
        c = Rgb(std::max(c.x, 0.0f), std::max(c.y, 0.0f), std::max(c.z, 0.0f));
    }
}

/// What a white of 1 is in the mean over the passes; 1 but for the choice of wavelengths. Never
/// so little that a pixel is blown up where a pass saw one end of the spectrum alone.
Imath::V3d white_of(const Imath::V3d& white_sum, double weight_sum) {
    constexpr double kLeast = 0.25;
    if (!(weight_sum > 0)) return Imath::V3d(1.0);
    const Imath::V3d mean = white_sum / weight_sum;
    return {std::max(mean.x, kLeast), std::max(mean.y, kLeast), std::max(mean.z, kLeast)};
}

}  // namespace

Imath::V3d FilmAccumulator::white(std::size_t part) const {
    const Mean& mean = part == 0 ? first_ : second_;
    return white_of(mean.white_sum, mean.weight_sum);
}

Imath::V3d FilmAccumulator::mean_value(const Mean& mean, std::size_t pixel,
                                       LightGroups groups) const {
    if (mean.sums.empty()) return Imath::V3d(0.0);
    const double* const sums = &mean.sums[pixel * (1 + 3 * std::size_t{groups_})];
    if (!(*sums > 0)) return Imath::V3d(0.0);
    return sum_over(sums + 1, groups) / (*sums * white(&mean == &second_ ? 1 : 0));
}

Imath::V3d FilmAccumulator::splat_value(std::size_t pixel, LightGroups groups) const {
    if (!(splat_samples_ > 0)) return Imath::V3d(0.0);
    const double pixels = static_cast<double>(width_) * height_;
    return sum_over(&splats_[pixel * 3 * groups_], groups) * pixels / (splat_samples_ * white(0));
}

/// A pixel's value summed over light groups: the means of samples, and the splats. Below zero where
/// negative lobes of the filter, or colours of wavelengths that RGB can't hold, have drawn it.
Rgb FilmAccumulator::resolve(std::size_t pixel, LightGroups groups) const {
    const Imath::V3d value = mean_value(first_, pixel, groups) +
                             mean_value(second_, pixel, groups) + splat_value(pixel, groups);
    return {finite_float(value.x), finite_float(value.y), finite_float(value.z)};
}

PixelMeans FilmAccumulator::means(std::size_t pixel) const {
    const LightGroups all{0, groups_};
    const std::size_t at = pixel * (1 + 3 * std::size_t{groups_});
    PixelMeans means;
    means.value = {mean_value(first_, pixel, all) + splat_value(pixel, all),
                   mean_value(second_, pixel, all)};
    means.weight[0] = std::max(first_.sums[at], 0.0);
    if (means.weight[0] == 0)
        means.weight[0] = splat_samples_ / (static_cast<double>(width_) * height_);
    if (has_second()) means.weight[1] = std::max(second_.sums[at], 0.0);
    return means;
}

void FilmAccumulator::resolve_group(std::uint32_t group, std::span<Rgb> image) const {
    resolve_groups({group, group + 1}, image);
}

void FilmAccumulator::resolve_total(std::span<Rgb> image) const {
    resolve_groups({0, groups_}, image);
}

void FilmAccumulator::resolve_groups(LightGroups groups, std::span<Rgb> image) const {
    tbb::parallel_for(std::size_t{0}, image.size(),
                      [&](std::size_t i) { image[i] = resolve(i, groups); });
    settle(image);
}

void FilmAccumulator::settle(std::span<Rgb> image) const {
    const bool lobes = filter_.has_negative_weights();
    if (to_rgb_ || !lobes) cut_below_zero(image, lobes);
    if (lobes) redistribute_negative_lobes(filtered(image));
}

FilteredImage FilmAccumulator::filtered(std::span<Rgb> image) const {
    const auto reach = [](float radius) { return static_cast<std::uint32_t>(std::ceil(radius)); };
    return {image, width_, height_, reach(filter_.radius_x()), reach(filter_.radius_y())};
}

void FilmAccumulator::settle_denoised(std::span<Rgb> image) const {
    settle(image);
    if (!filter_.has_negative_weights()) return;
    std::vector<Rgb> total(image.size());
    resolve_total(total);
    keep_dark_beside_bright(filtered(image), total);
}

}  // namespace lxs
