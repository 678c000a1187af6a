// The radiance estimate of a pass.
#include "estimate/pixel_estimate.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "aips/core/sampling/sampling.h"
#include "base/assign_all.h"

namespace aips {
namespace {

Rgb scaled(const Rgb& sum, double scale) {
    return {float(sum.r * scale), float(sum.g * scale), float(sum.b * scale)};
}

/// Radiance that photons bring by way of a visible point, from their `flux` there.
Rgb brought(const VisiblePoint& point, const Rgb& flux, double scale) {
    return point.throughput * left_out_f(point) * scaled(flux, scale);
}

/// Calls add(number of the visible point) for all, those of one eye path one after the other: they
/// share an entry of the image.
template <class Add>
void for_each_path(const EyeImage& image, const Add& add) {
    const auto& points = image.visible_points;
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
        const std::uint32_t path = points[i].sample;
        if (i > 0 && points[i - 1].sample == path) return;
        for (; i < points.size() && points[i].sample == path; ++i)
            add(i);
    });
}

Rgb least(const Rgb& a, const Rgb& b) {
    return {a.r < b.r ? a.r : b.r, a.g < b.g ? a.g : b.g, a.b < b.b ? a.b : b.b};
}

/// Makes parts sum to `all`. Direct light and caustics may be more by rounding, or where what they
/// were summed to was refused.
void split(const Rgb& all, std::span<Rgb> parts) {
    Rgb rest = all;
    for (std::size_t part = 0; part < kPhotonParts; ++part) {
        parts[part] = least(parts[part], rest);
        rest = rest - parts[part];
    }
    parts[std::size_t(ImagePart::Indirect)] = rest;
}

}  // namespace

double per_disk_and_path(float radius, std::uint64_t photon_paths) {
    return 1 / (double(kPi) * double(radius) * double(radius) * double(photon_paths));
}

void estimate_pixels(const EyeImage& image, const PhotonFlux& flux, const GatherRadii& radii,
                     std::uint64_t photon_paths, InvalidSampleFilter& filter,
                     std::vector<Rgb>& photon_radiance) {
    assign_all(photon_radiance, image.radiance.size(), Rgb{});
    const std::uint32_t groups = image.groups;
    for_each_path(image, [&](std::size_t i) {
        const VisiblePoint& point = image.visible_points[i];
        const double scale = per_disk_and_path(radii.of(i), photon_paths);
        for (std::uint32_t g = 0; g < groups; ++g) {
            const Rgb value = brought(point, flux.flux[i * groups + g], scale);
            filter.add(photon_radiance[std::size_t(point.sample) * groups + g], value,
                       point.material);
        }
    });
}

double luminance_of_point(const EyeImage& image, const PhotonFlux& flux, std::size_t i,
                          float radius, std::uint64_t photon_paths) {
    const double scale = per_disk_and_path(radius, photon_paths);
    float sum = 0;
    for (std::size_t g = 0; g < image.groups; ++g)
        sum += luminance(brought(image.visible_points[i], flux.flux[i * image.groups + g], scale));
    return double(sum);
}

void estimate_discs(const EyeImage& image, const PhotonFlux& flux, const GatherRadii& radii,
                    std::uint64_t photon_paths, DiscEstimates& discs) {
    assign_all(discs.whole, image.positions.size(), Rgb{});
    assign_all(discs.half, image.positions.size(), Rgb{});
    if (photon_paths == 0) return;
    for_each_path(image, [&](std::size_t i) {
        const VisiblePoint& point = image.visible_points[i];
        const double scale = per_disk_and_path(radii.of(i), photon_paths);
        const Rgb factor = point.throughput * left_out_f(point);
        Rgb sum;
        for (std::size_t g = 0; g < image.groups; ++g)
            sum += flux.flux[i * image.groups + g];
        const Rgb whole = factor * scaled(sum, scale);
        const Rgb half = factor * scaled(flux.inner[i], 2 * scale);
        if (!std::isfinite(whole.r + whole.g + whole.b + half.r + half.g + half.b)) return;
        discs.whole[point.sample] += whole;
        discs.half[point.sample] += half;
    });
}

void estimate_parts(const EyeImage& image, const PhotonFlux& flux, const GatherRadii& radii,
                    std::uint64_t photon_paths, std::span<const Rgb> of_media,
                    std::span<const Rgb> photon_radiance, std::vector<Rgb>& parts) {
    parts.assign(image.positions.size() * kImageParts, Rgb{});
    const auto add = [&](std::uint32_t path, std::size_t part, const Rgb& value) {
        parts[std::size_t(path) * kImageParts + part] += value;
    };
    for (std::size_t i = 0; i < image.visible_points.size(); ++i) {
        const VisiblePoint& point = image.visible_points[i];
        const Rgb factor = point.throughput * left_out_f(point);
        const double scale = per_disk_and_path(radii.of(i), photon_paths);
        for (std::size_t part = 0; part < kPhotonParts; ++part)
            add(point.sample, part, factor * scaled(flux.parts[i * kPhotonParts + part], scale));
    }
    for (std::size_t i = 0; i < of_media.size(); ++i)
        add(image.beams[i / kPhotonParts].sample, i % kPhotonParts, of_media[i]);
    for (std::size_t path = 0; path < image.positions.size(); ++path) {
        Rgb all;
        for (std::size_t g = 0; g < image.groups; ++g)
            all += photon_radiance[path * image.groups + g];
        split(all, std::span(parts).subspan(path * kImageParts, kImageParts));
    }
}

}  // namespace aips
