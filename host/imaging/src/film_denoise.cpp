// What a film keeps so that its image can be denoised, and the denoised image.
#include "film_denoise.h"

#include <algorithm>
#include <cmath>

#include "finite_float.h"
#include "for_pixels.h"
#include "lxs/denoise/denoise.h"

namespace lxs {
namespace {

/// Differences of reflectance, of a normal's coordinate (from 0 to 1) and of the depth's logarithm
/// that are none; see GuideChannel::least. Unit: 1, 1, 1, squared. Balances: noise of the guides
/// themselves against edges that they alone know. Chosen by: relMSE in 19 scenes.
constexpr float kLeastAlbedo = 1e-3f, kLeastNormal = 2.5e-3f, kLeastDepth = 1e-3f;

/// One channel of two halves' means, with the variance of their mean.
GuideChannel guide_of(const HalfMeans& halves, std::size_t pixels, int channel, float least) {
    GuideChannel guide{.value = std::vector<float>(pixels),
                       .variance = std::vector<float>(pixels),
                       .least = least};
    for_pixels(pixels, [&](std::size_t i) {
        const double a = halves.mean(0, i)[channel], b = halves.mean(1, i)[channel];
        guide.value[i] = finite_float(0.5 * (a + b));
        guide.variance[i] = finite_float(0.25 * (a - b) * (a - b));
    });
    return guide;
}

/// The slope along one axis: the lesser of both sides', so that an edge is none.
float slope(float before, float here, float after) {
    return std::min(std::abs(here - before), std::abs(after - here));
}

/// The depth's logarithm. What slopes tell of a pixel's neighbours counts as its variance, so that
/// a floor is one surface up to where it ends.
GuideChannel depth_guide(std::span<const float> depths, std::uint32_t width, std::uint32_t height) {
    GuideChannel guide{.value = std::vector<float>(depths.size()),
                       .variance = std::vector<float>(depths.size()),
                       .least = kLeastDepth};
    std::transform(depths.begin(), depths.end(), guide.value.begin(), [](float depth) {
        constexpr float kNearest = 1e-6f;
        return finite_float(std::log(std::max(depth, kNearest)));
    });
    constexpr float kNeighbours = 4;  // a slope's square counts as that of two pixels' distance
    for_pixels(depths.size(), [&](std::size_t i) {
        const std::size_t x = i % width, y = i / width;
        const float* const at = &guide.value[i];
        float squares = 0;
        if (x > 0 && x + 1 < width) squares += std::pow(slope(at[-1], at[0], at[1]), 2.0f);
        const auto row = static_cast<std::ptrdiff_t>(width);
        if (y > 0 && y + 1 < height) squares += std::pow(slope(at[-row], at[0], at[row]), 2.0f);
        guide.variance[i] = kNeighbours * squares;
    });
    return guide;
}

}  // namespace

FilmDenoise::FilmDenoise(std::uint32_t width, std::uint32_t height, const PixelFilter& filter)
    : width_(width),
      height_(height),
      guides_(guides(), width, height, filter),
      image_(pixels()),
      albedo_(pixels()),
      normal_(pixels()) {
    for (auto& squares : squares_)
        squares.resize(pixels());
}

void FilmDenoise::end_pass(const FilmAccumulator& film) {
    schedule_.end_pass();
    if (schedule_.full()) end_batch(film);
}

void FilmDenoise::end_batch(const FilmAccumulator& film) {
    const std::size_t half = schedule_.half();
    std::vector<Rgb> before(pixels());
    for_pixels(pixels(), [&](std::size_t i) { before[i] = Rgb(image_.mean(half, i)); });
    image_.end_batch(film, half);
    albedo_.end_batch(*guides_.albedo(), half);
    normal_.end_batch(*guides_.normal(), half);
    const auto old = static_cast<double>(schedule_.passes(half));
    const auto now = old + static_cast<double>(schedule_.open_passes());
    schedule_.close();
    if (old == 0) return;
    // n passes of variance v each move the mean by n / now of what tells them from those before,
    // whose square is v (1 / n + 1 / old) in the mean: times now old this leaves n v.
    const double factor = now * old;
    for_pixels(pixels(), [&](std::size_t i) {
        const Imath::V3d mean = image_.mean(half, i);
        for (int c = 0; c < 3; ++c) {
            const double moved = mean[c] - double{before[i][c]};
            float& sum = squares_[half][i][static_cast<std::size_t>(c)];
            sum = finite_float(double{sum} + factor * moved * moved);
        }
    });
}

void FilmDenoise::clear() {
    guides_.clear();
    schedule_ = {};
    for (HalfMeans* means : {&image_, &albedo_, &normal_})
        means->clear();
    for (auto& squares : squares_)
        std::fill(squares.begin(), squares.end(), std::array<float, 3>{});
}

bool FilmDenoise::known() const {
    return schedule_.passes(0) > schedule_.first_passes(0) &&
           schedule_.passes(1) > schedule_.first_passes(1);
}

std::vector<Rgb> FilmDenoise::image(const FilmAccumulator& film) const {
    if (schedule_.open_passes() == 0) return image();
    FilmDenoise whole = *this;
    whole.end_batch(film);
    return whole.image();
}

std::vector<Rgb> FilmDenoise::image() const {
    NoisyImage noisy{.width = width_, .height = height_, .halves = {}, .guides = {}};
    for (std::size_t h = 0; h < 2; ++h) {
        HalfImage& half = noisy.halves[h];
        const auto passes = static_cast<double>(schedule_.passes(h));
        const double told = passes - static_cast<double>(schedule_.first_passes(h));
        half = {std::vector<Rgb>(pixels()), std::vector<Rgb>(pixels()), passes};
        for_pixels(pixels(), [&](std::size_t i) {
            const Imath::V3d mean = image_.mean(h, i);
            for (int c = 0; c < 3; ++c) {
                const double sum = squares_[h][i][static_cast<std::size_t>(c)];
                half.mean[i][c] = finite_float(mean[c]);
                half.variance[i][c] = finite_float(sum / (told * passes));
            }
        });
    }
    for (int c = 0; c < 3; ++c) {
        noisy.guides.push_back(guide_of(albedo_, pixels(), c, kLeastAlbedo));
        noisy.guides.push_back(guide_of(normal_, pixels(), c, kLeastNormal));
    }
    noisy.guides.push_back(depth_guide(guides_.depth(), width_, height_));
    return denoise(noisy);
}

void FilmDenoise::state(StateArchive& archive) {
    guides_.state(archive);
    schedule_.state(archive);
    for (HalfMeans* means : {&image_, &albedo_, &normal_})
        means->state(archive);
    for (auto& squares : squares_) {
        archive.bytes(std::as_writable_bytes(std::span(squares)));
        const bool sound = std::all_of(squares.begin(), squares.end(), [](const auto& color) {
            return std::all_of(color.begin(), color.end(),
                               [](float v) { return std::isfinite(v) && v >= 0; });
        });
        if (!sound) throw StateError("a variance of the film's halves is no possible one");
    }
}

std::size_t FilmDenoise::memory_bytes() const {
    return guides_.memory_bytes() + image_.memory_bytes() + albedo_.memory_bytes() +
           normal_.memory_bytes() + 2 * pixels() * sizeof(std::array<float, 3>);
}

}  // namespace lxs
