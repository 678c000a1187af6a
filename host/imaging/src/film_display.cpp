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
/// of six scenes.
constexpr float kGivesWay = 0.75f, kGone = 0.5f;

/// Steps of brightness in which samples are kept apart, each this many times the one before; what
/// is brighter than the last is in it. Zirr et al. 2018 have 8 as well; six of them reach from the
/// mean of a part's first pass with light to some 30 000 times that.
constexpr std::size_t kLevels = 6;
constexpr double kStep = 8;

Rgb sum_over_groups(std::span<const Rgb> radiance) {
    Rgb sum(0.0f);
    for (const Rgb& group : radiance)
        sum += group;
    return sum;
}

/// At wavelengths as in RGB.
double brightness(const Rgb& c) {
    return (double{c.x} + double{c.y} + double{c.z}) / 3;
}

/// The greatest of those at most `reach` away, along rows and columns.
std::vector<float> greatest_around(std::span<const float> values, std::uint32_t width,
                                   std::uint32_t reach) {
    const auto along = [&](const std::vector<float>& from, std::size_t step, std::size_t length) {
        std::vector<float> most(from.size());
        for_pixels(from.size(), [&](std::size_t i) {
            const std::size_t at = i / step % length;
            const std::size_t before = std::min<std::size_t>(at, reach);
            const std::size_t after = std::min<std::size_t>(length - 1 - at, reach);
            for (std::size_t other = i - before * step; other <= i + after * step; other += step)
                most[i] = std::max(most[i], from[other]);
        });
        return most;
    };
    const std::vector<float> given(values.begin(), values.end());
    return along(along(given, 1, width), width, values.size() / width);
}

}  // namespace

FilmDisplay::FilmDisplay(std::uint32_t width, std::uint32_t height, const PixelFilter& filter,
                         std::uint32_t neighbours)
    : width_(width),
      height_(height),
      filter_(filter.central_lobe()),
      integral_(filter_),
      neighbours_(neighbours) {}

void FilmDisplay::add(const PassSamples& pass, const FilmAccumulator& film) {
    add_part(first_, pass, pass.radiance, pass.weight, film.cells(), nullptr);
    if (!pass.second_radiance.empty())
        add_part(second_, pass, pass.second_radiance, pass.second_weight, film.cells(), nullptr);
}

void FilmDisplay::add_splats(const PassSplats& splats, const FilmAccumulator& film) {
    const PassSamples pass{splats.positions, splats.radiance, splats.groups, splats.samples};
    add_part(splats_, pass, pass.radiance, splats.samples, film.cells(), &integral_);
}

/// `scale`: what a sample's radiance counts as in its pass, which has as many as `samples`.
void FilmDisplay::find_places(Mean& mean, const PassSamples& pass, std::span<const Rgb> radiance,
                              double scale, std::size_t samples) {
    const std::size_t count = pass.positions.size();
    const auto bright = [&](std::size_t i) {
        const double b =
            scale * brightness(sum_over_groups(radiance.subspan(i * pass.groups, pass.groups)));
        return std::isfinite(b) ? b : 0;
    };
    if (!(mean.least > 0)) {
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i)
            sum += bright(i);
        mean.least = sum / static_cast<double>(samples);
    }
    places_.assign(count, Place{});
    if (!(mean.least > 0)) return;  // black so far
    for_pixels(count, [&](std::size_t i) {
        const double above = bright(i) / mean.least;
        if (!(above > 1)) return;
        const double level = std::floor(std::log(above) / std::log(kStep));
        if (level >= kLevels - 1) {
            places_[i].level = kLevels - 1;
            return;
        }
        // So that a sample counts once in both levels together.
        const double lower = std::pow(kStep, level) / above;
        places_[i] = {
            static_cast<std::uint8_t>(level),
            static_cast<float>(std::clamp((lower - 1 / kStep) / (1 - 1 / kStep), 0.0, 1.0))};
    });
}

/// With an integral what a pixel gets is a density of splats, else a mean of samples.
void FilmDisplay::add_part(Mean& mean, const PassSamples& pass, std::span<const Rgb> radiance,
                           double weight, const SampleCells& cells,
                           const FilterIntegral* integral) {
    const std::size_t levels = rejects() ? kLevels : 1;
    mean.weights.resize(pixels());
    mean.levels.resize(levels);
    for (auto& level : mean.levels)
        level.resize(pixels(), Rgb(0.0f));
    const double per_splat = static_cast<double>(pixels()) / weight;
    if (rejects())
        find_places(mean, pass, radiance, integral ? per_splat : 1,
                    integral ? pixels() : pass.positions.size());
    mean.samples_per_pixel +=
        integral ? 1 : static_cast<double>(pass.positions.size()) / static_cast<double>(pixels());
    for_rows(height_, [&](std::uint32_t y) {
        const CellRange rows(y, filter_.radius_y(), height_);
        std::array<Imath::V3d, kLevels + 1> sums;
        for (std::uint32_t x = 0; x < width_; ++x) {
            const CellRange columns(x, filter_.radius_x(), width_);
            const Vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            double weights = 0;
            sums.fill(Imath::V3d(0.0));
            for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
                for (const std::uint32_t i : cells.samples(row, columns.first, columns.last)) {
                    const Vec2& p = pass.positions[i];
                    const double f = filter_.weight(p.x - centre.x, p.y - centre.y);
                    if (f == 0) continue;
                    weights += f;
                    const std::size_t at = std::size_t{i} * pass.groups;
                    const Imath::V3d light =
                        Imath::V3d(sum_over_groups(radiance.subspan(at, pass.groups))) * f;
                    if (levels == 1) {
                        sums[0] += light;
                        continue;
                    }
                    const Place& place = places_[i];
                    sums[place.level] += light * double{place.share};
                    sums[place.level + std::size_t{1}] += light * (1 - double{place.share});
                }
            }
            double added = weight * weights, scale = 1;
            if (integral) {
                weights = integral->over(x + 0.5, width_ - x - 0.5, y + 0.5, height_ - y - 0.5);
                scale = per_splat;
                added = weight;
            }
            if (!(weights > 0)) continue;
            const std::size_t pixel = std::size_t{y} * width_ + x;
            const double total = double{mean.weights[pixel]} + added;
            mean.weights[pixel] = finite_float(total);
            for (std::size_t l = 0; l < levels; ++l) {
                Imath::V3d now = sums[l] * (scale / weights);
                if (to_rgb_) now = now * *to_rgb_;
                Rgb& value = mean.levels[l][pixel];
                const Imath::V3d old(value);
                now = old + (now - old) * (added / total);
                value = {finite_float(now.x), finite_float(now.y), finite_float(now.z)};
            }
        }
    });
}

void FilmDisplay::clear() {
    first_ = second_ = splats_ = {};
}

template <class Part>
std::vector<Rgb> FilmDisplay::sum_of_parts(const FilmAccumulator& film, const Part& part) const {
    std::vector<Rgb> image(pixels());
    const std::array<Imath::V3d, 2> white{film.white(0), film.white(1)};
    for_pixels(pixels(), [&](std::size_t i) {
        const Imath::V3d sum =
            part(0, i) / white[0] + part(1, i) / white[1] + part(2, i) / white[0];
        for (int c = 0; c < 3; ++c)
            image[i][c] = std::max(finite_float(sum[c]), 0.0f);
    });
    return image;
}

std::vector<Rgb> FilmDisplay::image(const FilmAccumulator& film) const {
    const std::array<const Mean*, 3> means{&first_, &second_, &splats_};
    return sum_of_parts(film, [&](std::size_t part, std::size_t pixel) {
        Imath::V3d sum(0.0);
        for (const auto& level : means[part]->levels)
            sum += Imath::V3d(level[pixel]);
        return sum;
    });
}

/// The mean with each level weighed by how many samples of it, or of those next to it, lie in the
/// 3 x 3 pixels around.
std::vector<Rgb> FilmDisplay::reliable(const Mean& mean) const {
    if (mean.levels.empty()) return {};
    std::vector<Rgb> sum(mean.levels[0]);
    if (!(mean.least > 0)) return sum;
    std::vector<std::vector<float>> counts(kLevels, std::vector<float>(pixels()));
    for (std::size_t l = 0; l < kLevels; ++l) {
        const double one = mean.least * std::pow(kStep, static_cast<double>(l));
        for_pixels(pixels(), [&](std::size_t i) {
            counts[l][i] = finite_float(std::max(brightness(mean.levels[l][i]), 0.0) / one *
                                        mean.samples_per_pixel);
        });
    }
    for_pixels(pixels(), [&](std::size_t i) {
        const std::size_t x = i % width_, y = i / width_;
        std::array<double, kLevels> around{};
        for (std::size_t row = y - std::min<std::size_t>(y, 1);
             row <= std::min<std::size_t>(y + 1, height_ - 1); ++row) {
            for (std::size_t column = x - std::min<std::size_t>(x, 1);
                 column <= std::min<std::size_t>(x + 1, width_ - 1); ++column) {
                for (std::size_t l = 0; l < kLevels; ++l)
                    around[l] += double{counts[l][row * width_ + column]};
            }
        }
        for (std::size_t l = 1; l < kLevels; ++l) {
            const double near = around[l - 1] + around[l] + (l + 1 < kLevels ? around[l + 1] : 0);
            const double share = std::clamp((near - 1) / neighbours_, 0.0, 1.0);
            sum[i] += mean.levels[l][i] * static_cast<float>(share);
        }
    });
    return sum;
}

std::vector<Rgb> FilmDisplay::image_without_outliers(const FilmAccumulator& film) const {
    const std::array<std::vector<Rgb>, 3> parts{reliable(first_), reliable(second_),
                                                reliable(splats_)};
    return sum_of_parts(film, [&](std::size_t part, std::size_t pixel) {
        return parts[part].empty() ? Imath::V3d(0.0) : Imath::V3d(parts[part][pixel]);
    });
}

void FilmDisplay::state(StateArchive& archive) {
    const auto check = [](bool sound) {
        if (!sound) throw StateError("a sum of the film's display is no finite number");
    };
    const auto sound = [](double v) { return std::isfinite(v) && v >= 0; };
    for (Mean* mean : {&first_, &second_, &splats_}) {
        bool begun = !mean->weights.empty();
        archive.value(begun);
        if (archive.restoring()) *mean = {};
        if (!begun) continue;
        archive.value(mean->least);
        archive.value(mean->samples_per_pixel);
        check(sound(mean->least) && sound(mean->samples_per_pixel));
        mean->weights.resize(pixels());
        archive.fixed(mean->weights);
        check(std::all_of(mean->weights.begin(), mean->weights.end(), sound));
        mean->levels.resize(rejects() ? kLevels : 1);
        for (auto& level : mean->levels) {
            level.resize(pixels());
            archive.bytes(std::as_writable_bytes(std::span(level)));
            check(std::all_of(level.begin(), level.end(), [](const Rgb& c) {
                return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
            }));
        }
    }
}

std::size_t FilmDisplay::memory_bytes() const {
    std::size_t bytes = places_.capacity() * sizeof(Place);
    for (const Mean* mean : {&first_, &second_, &splats_}) {
        bytes += mean->weights.capacity() * sizeof(float);
        for (const auto& level : mean->levels)
            bytes += level.capacity() * sizeof(Rgb);
    }
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

void show_without_outliers(std::span<Rgb> shown, const Rejection& rejection) {
    std::vector<float> lost(shown.size());
    for_pixels(shown.size(), [&](std::size_t i) {
        const double all = brightness(rejection.all[i]);
        const double kept = brightness(rejection.kept[i]);
        lost[i] = all > 0 ? static_cast<float>(std::clamp(1 - kept / all, 0.0, 1.0)) : 0;
    });
    const std::vector<float> around = greatest_around(lost, rejection.width, rejection.reach);
    for_pixels(shown.size(), [&](std::size_t i) {
        if (around[i] == 0) return;
        for (int c = 0; c < 3; ++c) {
            const float all = rejection.all[i][c], kept = rejection.kept[i][c];
            const float own = all > 0 ? shown[i][c] * std::min(kept / all, 1.0f) : shown[i][c];
            shown[i][c] = own + around[i] * (kept - own);
        }
    });
}

double share_left_out(std::span<const Rgb> all, std::span<const Rgb> kept) {
    double whole = 0, left = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        whole += brightness(all[i]);
        left += brightness(all[i]) - brightness(kept[i]);
    }
    return whole > 0 ? std::max(left / whole, 0.0) : 0;
}

}  // namespace lxs
