// Density estimation at the visible points.
#include "estimate/gather.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>

#include "base/parallel_for.h"
#include "estimate/constants.h"
#include "estimate/group_sums.h"
#include "eye/surface_normals.h"

namespace aips {
namespace {

/// f * power of one landing, without the constant f of Lambertian points; black if rejected.
/// `in_front` tells whether the photon came from the side that the point's geometric normal shows,
/// as the surface was where it landed: on a thin curved sheet, one that grazes the far side may lie
/// on the near side of the point's tangent plane.
Rgb reflected(const VisiblePoint& point, const GridPhoton& landing, bool in_front) {
    if (!point.bsdf) {
        const bool same_side = in_front == (dot(point.wo, point.geometric_normal) > 0);
        return same_side ? landing.power * normal_ratio(point, landing.direction) : Rgb{};
    }
    // The Bsdf would take it for light from the other side.
    if (in_front != (dot(landing.direction, point.geometric_normal) > 0)) return {};
    // The photon's power already is flux; f alone remains, in the direction of radiance.
    return landing.power * normal_ratio(point, landing.direction) *
           point.bsdf->evaluate(point.wo, landing.direction, Transport::Radiance, point.receiving);
}

/// Calls scale(value) for all values, on all threads.
template <class T, class Scale>
void scale_each(std::vector<T>& values, const Scale& scale) {
    in_chunks(values.size(), kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        for (T& value : std::span(values).subspan(first, last - first))
            scale(value);
    });
}

}  // namespace

void PhotonFlux::scale(double factor) {
    const auto linear = float(factor), squared = float(factor * factor);
    const auto scale_light = [&](Rgb& sum) { sum = sum * linear; };
    for (std::vector<Rgb>* sums : {&flux, &parts, &inner})
        scale_each(*sums, scale_light);
    scale_each(squares, [&](float& square) { square *= squared; });
    scale_each(shareable, [&](ShareableFlux& part) {
        part = {float(part.sum * factor), float(part.squares * factor * factor)};
    });
    scale_each(probes, [&](ProbeSums& sums) { sums.scale(factor); });
}

bool on_same_surface(const VisiblePoint& point, Vec3 position, float agreement, float radius) {
    return std::abs(agreement) >= kMinNormalAgreement &&
           abs_dot(position - point.position, point.geometric_normal) <= kSlab * radius;
}

Rgb contribution(const VisiblePoint& point, const GridPhoton& landing, float radius) {
    const float agreement = dot(landing.normal, point.geometric_normal);
    if (!on_same_surface(point, landing.position, agreement, radius)) return {};
    const Rgb value = reflected(point, landing, agreement > 0);
    return landing.shareable && point.eye_share > 0 ? value * (1 - point.eye_share) : value;
}

void gather_photons(const EyeImage& image, const LandingGrid& grid, const SearchRadii& radii,
                    Refusals& refusals, PhotonFlux& result) {
    const std::uint32_t groups = image.groups;
    std::atomic<std::uint64_t> gathered{0};
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(image.owners.first(image.visible_points.size()),
                                        image.owners.last(image.visible_points.size()), 64),
        [&](const tbb::blocked_range<std::size_t>& range) {
            std::uint64_t total = 0;
            GroupSums sums(groups), parts(kPhotonParts), inner(1);
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                const VisiblePoint& point = image.visible_points[i];
                const float radius = radii.of(i);
                const float inner_square = radius * radius / 2;
                // Left out of the flux, but what it absorbs is no contribution.
                const Rgb f = point.bsdf ? kWhite : point.kd;
                std::uint32_t count = 0;
                double squares = 0, shareable = 0, shareable_squares = 0;
                grid.for_each_in_radius(point.position, radius, [&](const GridPhoton& landing) {
                    const Rgb value = contribution(point, landing, radius);
                    if (is_black(value * f) || !refusals.accept(value, point.material)) return;
                    sums.add(landing.light_group, value);
                    if (result.wants_parts) {
                        const ImagePart part =
                            point.scatterings.scattered_in(static_cast<ImagePart>(landing.part));
                        if (part != ImagePart::Indirect) parts.add(std::uint32_t(part), value);
                    }
                    if (result.wants_inner &&
                        length_squared(landing.position - point.position) <= inner_square)
                        inner.add(0, value);
                    const auto square = double(luminance(value) * luminance(value));
                    squares += square;
                    if (result.wants_shareable && landing.shareable) {
                        shareable += double(luminance(value));
                        shareable_squares += square;
                    }
                    ++count;
                });
                sums.move_to(&result.flux[i * groups]);
                result.accepted[i] = saturated_sum(result.accepted[i], count);
                result.squares[i] += float(squares);
                if (result.wants_parts) parts.move_to(&result.parts[i * kPhotonParts]);
                if (result.wants_inner) inner.move_to(&result.inner[i]);
                if (result.wants_shareable) {
                    result.shareable[i].sum += float(shareable);
                    result.shareable[i].squares += float(shareable_squares);
                }
                total += count;
            }
            gathered.fetch_add(total, std::memory_order_relaxed);
        });
    result.gathered += gathered.load();
}

void exchange_flux(const EyeImage& image, std::uint64_t gathered_before, SharedWork& work,
                   PhotonFlux& flux) {
    const std::uint64_t own = flux.gathered - gathered_before;
    work.exchange([&](std::uint32_t rank, StateArchive& archive) {
        plain_of_points(archive, image.owners, rank, flux.flux, image.groups);
        plain_of_points(archive, image.owners, rank, flux.accepted);
        plain_of_points(archive, image.owners, rank, flux.squares);
        plain_of_points(archive, image.owners, rank, flux.shareable);
        plain_of_points(archive, image.owners, rank, flux.parts, kPhotonParts);
        plain_of_points(archive, image.owners, rank, flux.inner);
        std::uint64_t gathered = own;
        archive.value(gathered);
        if (archive.restoring()) flux.gathered += gathered;
    });
}

}  // namespace aips
