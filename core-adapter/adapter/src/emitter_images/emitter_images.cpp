// Known images, and paths through them.
#include "emitter_images/emitter_images.h"

#include <algorithm>
#include <cmath>

#include "aips/core/sampling/low_discrepancy.h"
#include "aips/core/sampling/sampling.h"
#include "base/constants.h"
#include "base/film_pixel.h"
#include "base/vector_growth.h"
#include "emitter_images/constants.h"

namespace aips {
namespace {

/// Farthest that an image may reach from its middle along x or y (pixels).
constexpr float kFarthestReach = 4;

/// An image is known if its middle lies in one that is about as large, so much of it (share of the
/// known one's size).
constexpr float kKnownWithin = 0.5f;

/// Images are alike up to this ratio.
constexpr double kAlikeArea = 4;

constexpr std::uint32_t kNoEntry = ~std::uint32_t{0};

}  // namespace

EmitterImages::EmitterImages(std::uint32_t width, std::uint32_t height, double eye_paths_per_pixel)
    : width_(width),
      height_(height),
      per_pixel_(eye_paths_per_pixel),
      first_(pixel_count(), kNoEntry) {}

bool EmitterImages::suits(const EmitterImage& image) const {
    const Vec2 reach = image.reach();
    return image.area() > 0 && image.area() < kLargestImage &&
           std::max(reach.x, reach.y) < kFarthestReach && image.centre.x >= 0 &&
           image.centre.y >= 0 && image.centre.x < float(width_) && image.centre.y < float(height_);
}

/// Whether its middle lies well within an image like it.
bool EmitterImages::known(const EmitterImage& image) const {
    const std::uint32_t pixel = film_pixel(image.centre, width_, height_);
    for (std::uint32_t e = first_[pixel]; e != kNoEntry; e = entries_[e].next) {
        EmitterImage inner = images_[entries_[e].image];
        const double ratio = image.area() / inner.area();
        if (ratio > kAlikeArea || ratio * kAlikeArea < 1) continue;
        for (float& axis : inner.axes)
            axis *= kKnownWithin;
        SpecularChoices middle;
        for (std::size_t i = 0; i < middle.size(); ++i)
            middle[i] = 0.5f * (image.low[i] + image.high[i]);
        if (inner.pdf(image.centre, middle) > 0) return true;
    }
    return false;
}

template <class Use>
void EmitterImages::for_each_pixel(const EmitterImage& image, const Use& use) const {
    const Vec2 reach = image.reach();
    const Vec2 c = image.centre;
    const std::uint32_t low = film_pixel({c.x - reach.x, c.y - reach.y}, width_, height_);
    const std::uint32_t high = film_pixel({c.x + reach.x, c.y + reach.y}, width_, height_);
    for (std::uint32_t y = low / width_; y <= high / width_; ++y) {
        for (std::uint32_t x = low % width_; x <= high % width_; ++x)
            use(std::size_t{y} * width_ + x);
    }
}

/// Into the lists of its pixels.
void EmitterImages::file(std::uint32_t image) {
    for_each_pixel(images_[image], [&](std::size_t pixel) {
        entries_.push_back({image, first_[pixel]});
        first_[pixel] = std::uint32_t(entries_.size() - 1);
    });
}

/// Of its light; all where that is not known.
double EmitterImages::part_of_pixel(const EmitterImage& image, double mean_luminance) {
    if (!(mean_luminance > 0)) return 1;
    const double light = double(image.luminance) * image.area();
    return light / (light + kDarkestShare * mean_luminance);
}

void EmitterImages::add(std::span<const EmitterImage> found) {
    for (const EmitterImage& image : found) {
        if (images_.size() >= kMostImages || entries_.size() >= kMostEntries) break;
        if (!suits(image) || known(image)) continue;
        images_.push_back(image);
        file(std::uint32_t(images_.size() - 1));
    }
}

void EmitterImages::begin_pass(double mean_luminance) {
    const double parts = set_choice(mean_luminance);
    const double eye_paths = per_pixel_ * double(pixel_count());
    paths_ =
        std::uint32_t(std::min(std::ceil(kPathsPerImage * parts), kEmitterPathShare * eye_paths));
}

/// By the part of its pixel's light that an image is: what matters is the relative error. Returns
/// the sum of parts.
double EmitterImages::set_choice(double mean_luminance) {
    std::vector<float> parts(images_.size());
    for (std::size_t i = 0; i < images_.size(); ++i)
        parts[i] = float(std::max(part_of_pixel(images_[i], mean_luminance), kLeastImagePart));
    choice_.build(parts);
    return choice_.total();
}

EmitterDraw EmitterImages::draw(std::uint64_t seed, std::uint64_t pass, std::uint32_t i) const {
    const auto low = std::uint32_t(seed), high = std::uint32_t(seed >> 32);
    const std::uint32_t scramble =
        hash_bits(hash_bits(hash_bits(0x6C616D70u ^ low) + high) ^ std::uint32_t(pass));
    const auto u = [&](unsigned dimension) { return sobol_owen(i, dimension, scramble); };
    const EmitterImage& image = images_[choice_.sample(u(0)).index];
    return {image.film_at(square_to_concentric_disk({u(1), u(2)})),
            image.choices_at({u(3), u(4), u(5), u(6)})};
}

double EmitterImages::eye_share(Vec2 film, const SpecularChoices& choices) const {
    if (paths_ == 0) return 1;
    double density = 0;
    const std::uint32_t pixel = film_pixel(film, width_, height_);
    for (std::uint32_t e = first_[pixel]; e != kNoEntry; e = entries_[e].next) {
        const std::uint32_t image = entries_[e].image;
        density += double(choice_.pdf(image)) * images_[image].pdf(film, choices);
    }
    return per_pixel_ / (per_pixel_ + paths_ * density);
}

void EmitterImages::state(StateArchive& archive) {
    const std::size_t count = archive.count(images_.size(), sizeof(EmitterImage));
    StateArchive::check(count <= kMostImages, "more images of emitters than there may be");
    images_.resize(count);
    for (EmitterImage& image : images_) {
        archive.value(image.centre.x);
        archive.value(image.centre.y);
        for (auto* numbers : {&image.axes, &image.low, &image.high}) {
            for (float& number : *numbers)
                archive.value(number);
        }
        archive.value(image.luminance);
        StateArchive::check(suits(image), "an image of an emitter that has no place");
    }
    if (!archive.restoring()) return;
    for (std::uint32_t i = 0; i < count; ++i)
        file(i);
}

std::size_t EmitterImages::most_paths(std::size_t eye_paths) {
    return std::size_t(kEmitterPathShare * double(eye_paths)) + 1;
}

std::size_t EmitterImages::memory_bytes() const {
    return images_.capacity() * sizeof(EmitterImage) + first_.capacity() * sizeof(std::uint32_t) +
           entries_.capacity() * sizeof(Entry) + choice_.size() * sizeof(float);
}

std::size_t EmitterImages::memory_bound_bytes(std::size_t pixels) {
    constexpr auto kPixelsOfLast = std::size_t(4 * (kFarthestReach + 1) * (kFarthestReach + 1));
    return pixels * sizeof(std::uint32_t) +
           kVectorGrowth * (kMostImages * (sizeof(EmitterImage) + sizeof(float)) +
                            (kMostEntries + kPixelsOfLast) * sizeof(Entry));
}

}  // namespace aips
