// What a film's samples show when they are displayed, beside the image that is measured.
#include "film_display.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "finite_float.h"
#include "for_pixels.h"
#include "for_rows.h"

namespace lxs {
namespace {

/// Shares of the lobe-free mean below which a pixel begins to give way to it, and below which it
/// has done so. Unit: 1. Balances: dark rings around highlights against the sharpness that the
/// lobes are for, and against noise, by which the two differ too. Chosen by: dark dots in the PNG
/// of six scenes. Supported by: docs/notebook/2026-11-29-dots-beside-highlights.md.
constexpr float kGivesWay = 0.75f, kGone = 0.5f;

Rgb sum_over_groups(std::span<const Rgb> radiance) {
    Rgb sum(0.0f);
    for (const Rgb& group : radiance)
        sum += group;
    return sum;
}

}  // namespace

FilmDisplay::FilmDisplay(std::uint32_t width, std::uint32_t height, const PixelFilter& filter)
    : width_(width), height_(height), filter_(filter.central_lobe()), integral_(filter_) {}

void FilmDisplay::add(const PassSamples& pass, const FilmAccumulator& film) {
    add_part(first_, pass, pass.radiance, pass.weight, film.cells(), nullptr);
    if (!pass.second_radiance.empty())
        add_part(second_, pass, pass.second_radiance, pass.second_weight, film.cells(), nullptr);
}

void FilmDisplay::add_splats(const PassSplats& splats, const FilmAccumulator& film) {
    const PassSamples pass{splats.positions, splats.radiance, splats.groups, splats.samples};
    add_part(splats_, pass, pass.radiance, splats.samples, film.cells(), &integral_);
}

/// With an integral what a pixel gets is a density of splats, else a mean of samples.
void FilmDisplay::add_part(Mean& mean, const PassSamples& pass, std::span<const Rgb> radiance,
                           double weight, const SampleCells& cells,
                           const FilterIntegral* integral) {
    mean.weights.resize(pixels());
    mean.values.resize(pixels(), Rgb(0.0f));
    const double per_splat = static_cast<double>(pixels()) / weight;
    for_rows(height_, [&](std::uint32_t y) {
        const CellRange rows(y, filter_.radius_y(), height_);
        for (std::uint32_t x = 0; x < width_; ++x) {
            const CellRange columns(x, filter_.radius_x(), width_);
            const Vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            double weights = 0;
            Imath::V3d sum(0.0);
            for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
                for (const std::uint32_t i : cells.samples(row, columns.first, columns.last)) {
                    const Vec2& p = pass.positions[i];
                    const double f = filter_.weight(p.x - centre.x, p.y - centre.y);
                    if (f == 0) continue;
                    weights += f;
                    const std::size_t at = std::size_t{i} * pass.groups;
                    sum += Imath::V3d(sum_over_groups(radiance.subspan(at, pass.groups))) * f;
                }
            }
            double added = weight * weights;
            if (integral) {
                weights = integral->over(x + 0.5, width_ - x - 0.5, y + 0.5, height_ - y - 0.5);
                sum *= per_splat;
                added = weight;
            }
            if (!(weights > 0)) continue;
            if (to_rgb_) sum = sum * *to_rgb_;
            const std::size_t pixel = std::size_t{y} * width_ + x;
            const double total = double{mean.weights[pixel]} + added;
            const Imath::V3d old(mean.values[pixel]);
            const Imath::V3d now = old + (sum / weights - old) * (added / total);
            mean.weights[pixel] = finite_float(total);
            mean.values[pixel] = {finite_float(now.x), finite_float(now.y), finite_float(now.z)};
        }
    });
}

void FilmDisplay::clear() {
    first_ = second_ = splats_ = {};
}

std::vector<Rgb> FilmDisplay::image(const FilmAccumulator& film) const {
    std::vector<Rgb> image(pixels());
    const std::array<Imath::V3d, 2> white{film.white(0), film.white(1)};
    for_pixels(pixels(), [&](std::size_t i) {
        const auto of = [&](const Mean& mean, const Imath::V3d& divisor) {
            return mean.values.empty() ? Imath::V3d(0.0) : Imath::V3d(mean.values[i]) / divisor;
        };
        const Imath::V3d sum = of(first_, white[0]) + of(second_, white[1]) + of(splats_, white[0]);
        for (int c = 0; c < 3; ++c)
            image[i][c] = std::max(finite_float(sum[c]), 0.0f);
    });
    return image;
}

void FilmDisplay::state(StateArchive& archive) {
    for (Mean* mean : {&first_, &second_, &splats_}) {
        bool begun = !mean->weights.empty();
        archive.value(begun);
        if (archive.restoring()) *mean = {};
        if (!begun) continue;
        mean->weights.resize(pixels());
        mean->values.resize(pixels());
        archive.fixed(mean->weights);
        archive.bytes(std::as_writable_bytes(std::span(mean->values)));
        const auto finite = [](float v) { return std::isfinite(v); };
        const bool sound = std::all_of(mean->weights.begin(), mean->weights.end(),
                                       [](float w) { return std::isfinite(w) && w >= 0; }) &&
                           std::all_of(mean->values.begin(), mean->values.end(), [&](const Rgb& c) {
                               return finite(c.x) && finite(c.y) && finite(c.z);
                           });
        if (!sound) throw StateError("a sum of the film's display is no finite number");
    }
}

std::size_t FilmDisplay::memory_bytes() const {
    std::size_t bytes = 0;
    for (const Mean* mean : {&first_, &second_, &splats_})
        bytes += mean->weights.capacity() * sizeof(float) + mean->values.capacity() * sizeof(Rgb);
    return bytes;
}

void show_without_lobes(std::span<Rgb> shown, std::span<const Rgb> image,
                        std::span<const Rgb> lobe_free) {
    for_pixels(shown.size(), [&](std::size_t i) {
        for (int c = 0; c < 3; ++c) {
            const float whole = lobe_free[i][c];
            const float missing = kGivesWay * whole - image[i][c];
            if (!(missing > 0) || !(whole > shown[i][c])) continue;
            const float share = std::min(missing / ((kGivesWay - kGone) * whole), 1.0f);
            shown[i][c] += share * (whole - shown[i][c]);
        }
    });
}

}  // namespace lxs
