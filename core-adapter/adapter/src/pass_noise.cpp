// Noise between successive passes.
#include "pass_noise.h"

#include <utility>

#include "film_pixel.h"

namespace aips {

PassNoiseMeter::PassNoiseMeter(std::uint32_t width, std::uint32_t height)
    : width_(width),
      height_(height),
      pixels_(std::size_t{width} * height),
      last_(std::size_t{width} * height) {}

PassNoise PassNoiseMeter::add_pass(const EyeImage& image, std::span<const Rgb> photons,
                                   const PhotonFlux& flux, std::uint64_t photon_paths,
                                   const PixelImportance& importance) {
    std::swap(pixels_, last_);
    sum_pixels(image, photons, flux);
    double all = 0, of_photons = 0, photon_path = 0, compared = 0;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        const Pixel &now = pixels_[i], &before = last_[i];
        if (!(now.paths > 0 && before.paths > 0)) continue;
        const double weight = double(importance.weight(i));
        const double paths = now.paths, paths_before = before.paths;
        const double difference = now.sum / paths - before.sum / paths_before;
        const double first = double(before.variance) / (paths_before * paths_before);
        const double second = double(now.variance) / (paths * paths);
        all += weight * difference * difference / 2;
        of_photons += weight * (first + second) / 2;
        photon_path += weight * (first * double(last_paths_) + second * double(photon_paths)) / 2;
        compared += 1;
    }
    last_paths_ = photon_paths;
    if (!(compared > 0)) return {};
    return {(all - of_photons) / compared, photon_path / compared};
}

// A visible point's sum of squares over the square of its sum is the relative variance of what its
// photons bring, as if they came independently; stratified ones come more evenly.
void PassNoiseMeter::sum_pixels(const EyeImage& image, std::span<const Rgb> photons,
                                const PhotonFlux& flux) {
    pixels_.assign(pixels_.size(), {});
    const auto luminance_of = [&](std::span<const Rgb> values, std::size_t path) {
        return luminance_over_groups(values, path, image.groups);
    };
    for (std::size_t path = 0; path < image.positions.size(); ++path) {
        Pixel& pixel = pixels_[film_pixel(image.positions[path], width_, height_)];
        pixel.sum +=
            double(luminance_of(image.radiance, path)) + double(luminance_of(photons, path));
        ++pixel.paths;
    }
    for (std::size_t i = 0; i < image.visible_points.size(); ++i) {
        const float brought = luminance_of(flux.flux, i);
        if (!(brought > 0)) continue;
        const std::size_t path = image.visible_points[i].sample;
        const float share = luminance_of(photons, path) / brought;
        Pixel& pixel = pixels_[film_pixel(image.positions[path], width_, height_)];
        pixel.variance += share * share * flux.squares[i];
    }
}

// Whatever is restored, it gives an estimate of noise at worst that is none.
void PassNoiseMeter::state(StateArchive& archive) {
    for (Pixel& pixel : pixels_) {
        archive.value(pixel.sum);
        archive.value(pixel.variance);
        archive.value(pixel.paths);
    }
    archive.value(last_paths_);
}

std::size_t PassNoiseMeter::memory_bytes() const {
    return (pixels_.capacity() + last_.capacity()) * sizeof(Pixel);
}

}  // namespace aips
