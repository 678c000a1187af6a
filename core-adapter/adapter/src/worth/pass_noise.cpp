// Noise between successive passes.
#include "worth/pass_noise.h"

#include <utility>

#include "base/parallel_for.h"
#include "estimate/group_sums.h"

namespace aips {

// A visible point's sum of squares over the square of its sum is the relative variance of what its
// photons bring, as if they came independently; stratified ones come more evenly.
void photon_variances(const EyeImage& image, std::span<const Rgb> photons, const PhotonFlux& flux,
                      std::vector<float>& variances) {
    variances.assign(image.positions.size(), 0);
    const auto& points = image.visible_points;
    in_chunks(points.size(), kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t path = points[i].sample;
            add_variance(
                variances[path], double(luminance_over_groups(photons, path, image.groups)),
                double(luminance_over_groups(flux.flux, i, image.groups)), flux.squares[i]);
        }
    });
}

PassNoiseMeter::PassNoiseMeter(std::uint32_t width, std::uint32_t height)
    : pixels_(std::size_t{width} * height), last_(std::size_t{width} * height) {}

PassNoise PassNoiseMeter::add_pass(std::span<const PixelLuminance> seen,
                                   std::span<const float> variances, std::uint64_t photon_paths,
                                   const PixelImportance& importance) {
    std::swap(pixels_, last_);
    sum_pixels(seen, variances);
    // By chunks that the film alone decides, so that sums round alike for any number of threads.
    std::vector<Differences> parts(pixels_.size() / kItemsPerJob + 1);
    in_chunks(pixels_.size(), kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        parts[first / kItemsPerJob] = compare(first, last, photon_paths, importance);
    });
    Differences sums;
    for (const Differences& part : parts) {
        sums.all += part.all;
        sums.trimmed += part.trimmed;
        sums.of_photons += part.of_photons;
        sums.photon_path += part.photon_path;
        sums.pixels += part.pixels;
    }
    last_paths_ = photon_paths;
    if (!(sums.pixels > 0)) return {};
    return {(sums.all - sums.of_photons) / sums.pixels, sums.photon_path / sums.pixels,
            sums.trimmed / sums.pixels};
}

PassNoiseMeter::Differences PassNoiseMeter::compare(std::size_t first, std::size_t last,
                                                    std::uint64_t photon_paths,
                                                    const PixelImportance& importance) const {
    Differences sums;
    for (std::size_t i = first; i < last; ++i) {
        const Pixel &now = pixels_[i], &before = last_[i];
        if (!(now.paths > 0 && before.paths > 0)) continue;
        const double weight = double(importance.weight(i));
        const double paths = now.paths, paths_before = before.paths;
        const double difference = now.sum / paths - before.sum / paths_before;
        const double of_before = double(before.variance) / (paths_before * paths_before);
        const double of_now = double(now.variance) / (paths * paths);
        const double squared = difference * difference / 2;
        const auto shared_weight = double(importance.weight_of_sharing(i));
        sums.all += weight * squared;
        sums.trimmed += shared_weight * trimmed(squared, shared_weight);
        sums.of_photons += weight * (of_before + of_now) / 2;
        sums.photon_path +=
            weight * (of_before * double(last_paths_) + of_now * double(photon_paths)) / 2;
        sums.pixels += 1;
    }
    return sums;
}

void PassNoiseMeter::sum_pixels(std::span<const PixelLuminance> seen,
                                std::span<const float> variances) {
    pixels_.assign(pixels_.size(), {});
    for (std::size_t i = 0; i < seen.size(); ++i) {
        Pixel& pixel = pixels_[seen[i].pixel];
        pixel.sum += seen[i].luminance;
        pixel.variance += variances[i];
        ++pixel.paths;
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

std::size_t PassNoiseMeter::memory_bound_bytes(std::size_t pixels) {
    return pixels * 2 * sizeof(Pixel);
}

}  // namespace aips
