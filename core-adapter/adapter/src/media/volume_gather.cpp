// The beam radiance estimate. A beam is cut into pieces as long as they are wide, and each of them,
// or a random choice where a beam has many, takes the photons of its cylinder out of a ball: every
// photon near the beam belongs to exactly one piece.
#include "media/volume_gather.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "aips/core/sampling/sampling.h"
#include "base/parallel_for.h"
#include "base/vector_growth.h"
#include "media/constants.h"
#include "radii/radius_policy.h"
#include "radii/scheduled_radius.h"

namespace aips {
namespace {

/// Part of a beam, and what its photons count for.
struct Piece {
    float from = 0, to = 0;
    float weight = 1;
};

}  // namespace

/// Of one beam.
struct VolumeGather::BeamSums {
    explicit BeamSums(std::uint32_t groups) : by_group(groups), parts(kPhotonParts), inner(1) {}
    GroupSums by_group, parts, inner;
};

VolumeGather::VolumeGather(const Scene& scene, const Settings& settings)
    : scene_(scene), settings_(settings) {}

void VolumeGather::begin_pass(std::uint64_t pass, const PassPhotons& photons, const EyeImage& image,
                              VolumeWants wants) {
    pass_ = pass;
    waiting_.clear();
    flux_.assign(image.beams.size() * image.groups, Rgb{});
    part_flux_.assign(wants.parts ? image.beams.size() * kPhotonParts : 0, Rgb{});
    inner_flux_.assign(wants.inner ? image.beams.size() : 0, Rgb{});
    squares_.assign(image.beams.size(), 0.0f);
    const double smallest = smallest_radius(scene_);
    if (!(initial_radius_ > 0) && !image.beams.empty()) {
        initial_radius_ =
            kSurfaceRadii *
            radius_of_footprint(settings_, image.beam_footprint_sum / double(image.beams.size()),
                                smallest);
    }
    radius_ = settings_.mode == Mode::PhotonMap
                  ? float(initial_radius_)
                  : scheduled_radius(settings_, initial_radius_, double(photons.before), smallest);
}

void VolumeGather::scale_power(std::size_t first, float factor) {
    for (std::size_t i = first; i < waiting_.size(); ++i)
        waiting_[i].power *= factor;
}

void VolumeGather::sort() {
    positions_.resize(waiting_.size());
    for (std::size_t i = 0; i < waiting_.size(); ++i)
        positions_[i] = waiting_[i].position;
    // The ball around a piece, half of which is as long as it is wide.
    cells_.build(positions_, radius_ * std::numbers::sqrt2_v<float>, tbb_for);
    photons_.resize(cells_.size());
    for (std::size_t slot = 0; slot < cells_.size(); ++slot)
        photons_[slot] = waiting_[cells_.order()[slot]];
}

std::uint64_t VolumeGather::gather_beam(const VolumeBeam& beam, InvalidSampleFilter& filter,
                                        BeamSums& sums, float& squares) const {
    const Media& media = *scene_.media();
    const Rgb extinction = media.extinction(beam.medium);
    const float width = 2 * radius_;
    std::uint64_t gathered = 0;
    double square_sum = 0;
    const auto gather_piece = [&](const Piece& piece) {
        const Vec3 middle = beam.at(0.5f * (piece.from + piece.to));
        cells_.for_each_in_radius(middle, cells_.radius(), [&](std::uint32_t slot) {
            const VolumePhoton& photon = photons_[slot];
            const Vec3 to_photon = photon.position - beam.origin;
            const float t = dot(to_photon, beam.direction);
            if (photon.bounces > beam.photon_bounces) return;
            if (photon.medium != beam.medium || !(t >= piece.from && t < piece.to)) return;
            const float off_square = length_squared(to_photon - beam.direction * t);
            if (off_square > radius_ * radius_) return;
            const Rgb value = photon.power * transmittance(extinction, t) *
                              media.phase(beam.medium, dot(photon.direction, beam.direction)) *
                              piece.weight;
            if (!filter.accept(value, kPassageOrigin)) return;
            sums.by_group.add(photon.light_group, value);
            if (!inner_flux_.empty() && off_square <= radius_ * radius_ / 2)
                sums.inner.add(0, value);
            if (!part_flux_.empty()) {
                const ImagePart part = beam.scatterings.scattered_in(photon.part);
                if (part != ImagePart::Indirect) sums.parts.add(std::uint32_t(part), value);
            }
            square_sum += double(luminance(value)) * double(luminance(value));
            ++gathered;
        });
    };
    const auto piece_at = [&](std::uint32_t i) {
        return Piece{float(i) * width, std::min(float(i + 1) * width, beam.length), 1};
    };
    const double count = std::ceil(double(beam.length) / width);
    if (count <= kMostPieces) {
        for (std::uint32_t i = 0; i < std::uint32_t(count); ++i)
            gather_piece(piece_at(i));
        squares += float(square_sum);
        return gathered;
    }
    const SegmentExponential distances(extinction, media.scattering(beam.medium), beam.length);
    const auto gather_drawn = [&](std::uint32_t number, std::uint32_t times) {
        Piece piece = piece_at(number);
        piece.weight = float(times) / (kMostPieces * distances.probability(piece.from, piece.to));
        if (times > 0 && piece.to > piece.from) gather_piece(piece);
    };
    RandomStream random(settings_.seed, pass_, beam.sample, RandomDomain::VolumePieces);
    // Strata come in order, so that draws of one piece are neighbours. It is gathered once for all
    // of them: what a photon brings is then one value, whose square is its noise.
    std::uint32_t drawn = 0, times = 0;
    for (std::uint32_t i = 0; i < kMostPieces; ++i) {
        // The sum of a stratum and u may round up to the next stratum's begin, at last to 1.
        const float t =
            distances.sample(std::min((float(i) + random.next()) / kMostPieces, kBelowOne));
        const auto number = std::uint32_t(std::min(double(t / width), count - 1));
        if (number != drawn) {
            gather_drawn(drawn, times);
            drawn = number;
            times = 0;
        }
        ++times;
    }
    gather_drawn(drawn, times);
    squares += float(square_sum);
    return gathered;
}

void VolumeGather::gather(const EyeImage& image, InvalidSampleFilter& filter) {
    if (waiting_.empty() || image.beams.empty()) return waiting_.clear();
    sort();
    std::atomic<std::uint64_t> gathered{0};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, image.beams.size(), 256),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          std::uint64_t total = 0;
                          BeamSums sums(image.groups);
                          for (std::size_t i = range.begin(); i < range.end(); ++i) {
                              total += gather_beam(image.beams[i], filter, sums, squares_[i]);
                              sums.by_group.move_to(&flux_[i * image.groups]);
                              if (!part_flux_.empty())
                                  sums.parts.move_to(&part_flux_[i * kPhotonParts]);
                              if (!inner_flux_.empty()) sums.inner.move_to(&inner_flux_[i]);
                          }
                          gathered.fetch_add(total, std::memory_order_relaxed);
                      });
    gathered_ += gathered.load();
    waiting_.clear();
}

void VolumeGather::scale_flux(float factor) {
    for (Rgb& sum : flux_)
        sum *= factor;
    for (Rgb& sum : part_flux_)
        sum *= factor;
    for (Rgb& sum : inner_flux_)
        sum *= factor;
    for (float& square : squares_)
        square *= factor * factor;
}

double VolumeGather::per_disc_and_path(std::uint64_t photon_paths) const {
    return 1 / (double(kPi) * double(radius_) * double(radius_) * double(photon_paths));
}

Rgb VolumeGather::radiance_of(const VolumeBeam& beam, const Rgb& sum, double scale) const {
    const Rgb density{float(sum.r * scale), float(sum.g * scale), float(sum.b * scale)};
    return beam.throughput * scene_.media()->scattering(beam.medium) * density;
}

void VolumeGather::add_to(const EyeImage& image, std::uint64_t photon_paths,
                          InvalidSampleFilter& filter, std::vector<Rgb>& radiance,
                          std::span<float> variances) const {
    if (image.beams.empty()) return;
    const double scale = per_disc_and_path(photon_paths);
    for (std::size_t i = 0; i < image.beams.size(); ++i) {
        const VolumeBeam& beam = image.beams[i];
        double added = 0;
        for (std::uint32_t g = 0; g < image.groups; ++g) {
            const Rgb value = radiance_of(beam, flux_[i * image.groups + g], scale);
            Rgb& sum_of_path = radiance[std::size_t(beam.sample) * image.groups + g];
            if (filter.add(sum_of_path, value, kPassageOrigin)) added += double(luminance(value));
        }
        if (variances.empty()) continue;
        const double brought = double(luminance_over_groups(flux_, i, image.groups));
        add_variance(variances[beam.sample], added, brought, squares_[i]);
    }
}

std::vector<Rgb> VolumeGather::parts(const EyeImage& image, std::uint64_t photon_paths) const {
    const double scale = per_disc_and_path(photon_paths);
    std::vector<Rgb> parts(part_flux_.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
        parts[i] = radiance_of(image.beams[i / kPhotonParts], part_flux_[i], scale);
    return parts;
}

void VolumeGather::add_discs(const EyeImage& image, std::uint64_t photon_paths,
                             DiscEstimates& discs) const {
    if (inner_flux_.empty()) return;
    const double scale = per_disc_and_path(photon_paths);
    for (std::size_t i = 0; i < image.beams.size(); ++i) {
        const VolumeBeam& beam = image.beams[i];
        Rgb sum;
        for (std::size_t g = 0; g < image.groups; ++g)
            sum += flux_[i * image.groups + g];
        const Rgb whole = radiance_of(beam, sum, scale);
        const Rgb half = radiance_of(beam, inner_flux_[i], 2 * scale);
        if (!std::isfinite(whole.r + whole.g + whole.b + half.r + half.g + half.b)) continue;
        discs.whole[beam.sample] += whole;
        discs.half[beam.sample] += half;
    }
}

void VolumeGather::state(StateArchive& archive) {
    state_of_initial_radius(archive, initial_radius_, kSurfaceRadii * smallest_radius(scene_));
}

std::size_t VolumeGather::memory_bytes() const {
    return (waiting_.capacity() + photons_.capacity()) * sizeof(VolumePhoton) +
           positions_.capacity() * sizeof(Vec3) + cells_.memory_bytes() +
           (flux_.capacity() + part_flux_.capacity() + inner_flux_.capacity()) * sizeof(Rgb) +
           squares_.capacity() * sizeof(float);
}

std::size_t VolumeGather::memory_bound_bytes(const Scene& scene, std::size_t eye_paths,
                                             std::size_t iteration) {
    const std::size_t photons = kWaitingPhotons + iteration;
    return kVectorGrowth * (2 * photons + iteration) * sizeof(VolumePhoton) +
           kVectorGrowth * photons * sizeof(Vec3) + CellSort::memory_bound_bytes(photons) +
           eye_paths * (scene.light_groups() * sizeof(Rgb) + sizeof(float));
}

}  // namespace aips
