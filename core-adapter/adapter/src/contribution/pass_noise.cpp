// Noise between successive passes.
#include "contribution/pass_noise.h"

#include <utility>

#include "base/assign_all.h"
#include "base/disjoint_ranges.h"
#include "base/ordered_sum.h"
#include "estimate/group_sums.h"

namespace aips {

// A visible point's sum of squares over the square of its sum is the relative variance of what its
// photons bring, as if they came independently; stratified ones come more evenly.
void photon_variances(const EyeImage& image, std::span<const Rgb> photons, const PhotonFlux& flux,
                      std::vector<float>& variances) {
    assign_all(variances, image.positions.size(), 0.0f);
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
                                   const PhotonVariances& variances, std::uint64_t photon_paths,
                                   const PixelImportance& importance) {
    std::swap(pixels_, last_);
    sum_pixels(seen, variances);
    const auto sums =
        ordered_sum<Differences>(pixels_.size(), [&](std::size_t first, std::size_t last) {
            return compare(first, last, photon_paths, importance);
        });
    last_paths_ = photon_paths;
    if (!(sums.pixels > 0)) return {};
    return {sums.all / sums.pixels, sums.photon_path / sums.pixels, sums.beam_path / sums.pixels};
}

PassNoiseMeter::Differences PassNoiseMeter::compare(std::size_t first, std::size_t last,
                                                    std::uint64_t photon_paths,
                                                    const PixelImportance& importance) const {
    Differences sums;
    for (std::size_t i = first; i < last; ++i) {
        const Pixel &now = pixels_[i], &before = last_[i];
        if (!(now.paths > 0 && before.paths > 0)) continue;
        const auto weight = double(importance.weight_of_sharing(i));
        const double paths = now.paths, paths_before = before.paths;
        const double difference = now.sum / paths - before.sum / paths_before;
        // Of a single photon path, from what all of both passes brought.
        const auto of_a_path = [&](float of_before, float of_now) {
            const double a = trimmed(double(of_before) / (paths_before * paths_before), weight);
            const double b = trimmed(double(of_now) / (paths * paths), weight);
            return weight * (a * double(last_paths_) + b * double(photon_paths)) / 2;
        };
        sums.all += weight * trimmed(difference * difference / 2, weight);
        sums.photon_path += of_a_path(before.variance, now.variance);
        sums.beam_path += of_a_path(before.of_beam, now.of_beam);
        sums.pixels += 1;
    }
    return sums;
}

void PassNoiseMeter::sum_pixels(std::span<const PixelLuminance> seen,
                                const PhotonVariances& variances) {
    assign_all(pixels_, pixels_.size(), Pixel{});
    in_disjoint_ranges(
        seen.size(), [&](std::size_t i) { return seen[i].pixel; },
        [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                Pixel& pixel = pixels_[seen[i].pixel];
                pixel.sum += seen[i].luminance;
                if (!variances.surfaces.empty()) pixel.variance += variances.surfaces[i];
                if (!variances.beams.empty())
                    pixel.of_beam += variances.beams[i] / float(variances.thinning);
                ++pixel.paths;
            }
        });
}

// Whatever is restored, it gives an estimate of noise at worst that is none.
void PassNoiseMeter::state(StateArchive& archive) {
    for (Pixel& pixel : pixels_) {
        archive.value(pixel.sum);
        archive.value(pixel.variance);
        archive.value(pixel.of_beam);
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
