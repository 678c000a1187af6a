// The beam radiance estimate. A beam finds the photons beside it in the runs of a grid, and then
// asks the medium about all of them at once.
#include "media/volume_gather.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "aips/core/sampling/sampling.h"
#include "base/parallel_for.h"
#include "base/vector_growth.h"
#include "media/constants.h"
#include "radii/radius_policy.h"
#include "radii/scheduled_radius.h"

namespace aips {
/// Of one beam.
struct VolumeGather::BeamSums {
    explicit BeamSums(std::uint32_t groups) : by_group(groups), parts(kPhotonParts), inner(1) {}
    GroupSums by_group, parts, inner;
    double luminance = 0, squares = 0;    // of one beam: of its photons
    std::uint64_t photons = 0, rays = 0;  // of all beams

    void scale(double factor) {
        for (GroupSums* sums : {&by_group, &parts, &inner})
            sums->scale(factor);
        squares *= factor * factor;
    }
};

/// Photons beside a beam: where along it, and what the medium says of them.
struct VolumeGather::Found {
    std::vector<std::uint32_t> slots;
    std::vector<float> distances, cosines;
    std::vector<Rgb> passed, phases;
    std::vector<double> brought;  // luminance of the photons up to each
    std::size_t count = 0;
    float thinning = 0, boundary = 0, collisions = 0;  // numbers in [0, 1) that draw for the beam

    void make_room(std::size_t more) {
        if (count + more <= slots.size()) return;
        slots.resize(2 * (count + more));
        distances.resize(slots.size());
    }
};

VolumeGather::VolumeGather(const Scene& scene, const Settings& settings)
    : scene_(scene), settings_(settings) {
    // Only both together make an estimate that is right on the whole.
    if (settings.photon_occlusion && settings.correct_edges) boundary_.emplace(scene);
}

void VolumeGather::begin_pass(std::uint64_t pass, float time, const PassPhotons& photons,
                              const EyeImage& image, VolumeWants wants) {
    pass_ = pass;
    thinning_ = photons.thinning;
    waiting_.clear();
    flux_.assign(image.beams.size() * image.groups, Rgb{});
    part_flux_.assign(wants.parts ? image.beams.size() * kPhotonParts : 0, Rgb{});
    inner_flux_.assign(wants.inner ? image.beams.size() : 0, Rgb{});
    squares_.assign(image.beams.size(), 0.0f);
    if (boundary_) boundary_->begin_pass(pass, time, image.beams.size());
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
    grid_.build(positions_, radius_, thinning_, tbb_for);
    photons_.resize(grid_.size());
    for_all(grid_.size(),
            [&](std::size_t slot) { photons_[slot] = waiting_[grid_.order()[slot]]; });
}

// Which of the candidates lie within the radius is as good as random, so they are picked out
// without a branch.
void VolumeGather::find(const VolumeBeam& beam, Found& found) const {
    found.count = 0;
    RandomStream random(settings_.seed, pass_, beam.sample, RandomDomain::BeamPhotons);
    found.thinning = random.next();
    found.boundary = random.next();
    found.collisions = random.next();
    // Which of the slots, whose order has nothing to do with what their photons bring.
    const std::uint32_t chosen =
        std::min(std::uint32_t(found.thinning * float(thinning_)), thinning_ - 1);
    const float radius_squared = radius_ * radius_;
    const Vec3 origin = beam.origin, direction = beam.direction;
    const float length = beam.length;
    const Vec3* const positions = grid_.positions().data();
    grid_.for_each_run({origin, direction, length}, [&](std::uint32_t first, std::uint32_t last) {
        found.make_room(last - first);
        std::uint32_t* const slots = found.slots.data();
        float* const distances = found.distances.data();
        std::size_t count = found.count;
        for (std::uint32_t slot = first + ((chosen - first) & (thinning_ - 1)); slot < last;
             slot += thinning_) {
            const Vec3 to_photon = positions[slot] - origin;
            const float t = dot(to_photon, direction);
            const float off_square = length_squared(to_photon - direction * t);
            slots[count] = slot;
            distances[count] = t;
            count += std::size_t(off_square <= radius_squared) & std::size_t(t >= 0) &
                     std::size_t(t < length);
        }
        found.count = count;
    });
    found.cosines.resize(found.count);
    std::size_t count = 0;
    for (std::size_t i = 0; i < found.count; ++i) {
        const VolumePhoton& photon = photons_[found.slots[i]];
        if (photon.medium != beam.medium || photon.bounces > beam.photon_bounces) continue;
        found.slots[count] = found.slots[i];
        found.distances[count] = found.distances[i];
        found.cosines[count++] = dot(photon.direction, direction);
    }
    found.count = count;
    found.cosines.resize(count);
}

void VolumeGather::gather_beam(const VolumeBeam& beam, InvalidSampleFilter& filter, Found& found,
                               BeamSums& sums) const {
    sums.luminance = sums.squares = 0;
    find(beam, found);
    const std::size_t count = found.count;
    if (count == 0) return;
    const Media& media = *scene_.media();
    found.passed.resize(count);
    media.transmittances(beam.medium, beam.ray(), {found.distances.data(), count}, found.collisions,
                         found.passed);
    found.phases.resize(count);
    media.phases(beam.medium, found.cosines, found.phases);
    const auto inner_square = double(radius_) * radius_ / 2;
    found.brought.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const VolumePhoton& photon = photons_[found.slots[i]];
        const Rgb value = photon.power * found.passed[i] * found.phases[i] * float(thinning_);
        found.brought[i] = sums.luminance;
        if (!filter.accept(value, kPassageOrigin)) continue;
        sums.by_group.add(photon.light_group, value);
        if (!inner_flux_.empty() &&
            length_squared(photon.position - beam.at(found.distances[i])) <= inner_square)
            sums.inner.add(0, value);
        if (!part_flux_.empty()) {
            const ImagePart part = beam.scatterings.scattered_in(photon.part);
            if (part != ImagePart::Indirect) sums.parts.add(std::uint32_t(part), value);
        }
        const auto light = double(luminance(value));
        found.brought[i] = sums.luminance += light;
        sums.squares += light * light;
        ++sums.photons;
    }
}

float VolumeGather::boundary_factor(const EyeImage& image, std::size_t number, const Found& found,
                                    BeamSums& sums) {
    const VolumeBeam& beam = image.beams[number];
    if (!(sums.luminance > 0) || !std::isfinite(sums.luminance)) return 1;
    const Vec2 film = image.positions[beam.sample];
    const std::uint32_t asks = boundary_->asks(beam, number, film);
    if (asks == 0) return 1;
    float sum = 0;
    for (std::uint32_t i = 0; i < asks; ++i) {
        const double at = (i + double(found.boundary)) / asks * sums.luminance;
        const auto drawn = std::upper_bound(found.brought.begin(), found.brought.end(), at);
        const auto last = std::ptrdiff_t(found.count) - 1;
        const auto k = std::size_t(std::min(drawn - found.brought.begin(), last));
        sum += boundary_->factor(beam, number, found.distances[k],
                                 photons_[found.slots[k]].position, radius_);
    }
    sums.rays += 2 * std::uint64_t{asks};
    return sum / float(asks);
}

void VolumeGather::end_pass(const EyeImage& image) {
    if (boundary_) boundary_->end_pass(image.beams, image.positions);
}

void VolumeGather::gather(const EyeImage& image, InvalidSampleFilter& filter) {
    if (waiting_.empty() || image.beams.empty()) return waiting_.clear();
    sort();
    std::atomic<std::uint64_t> gathered{0}, rays{0};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, image.beams.size(), 256),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          Found found;
                          BeamSums sums(image.groups);
                          for (std::size_t i = range.begin(); i < range.end(); ++i) {
                              gather_beam(image.beams[i], filter, found, sums);
                              if (boundary_)
                                  sums.scale(double(boundary_factor(image, i, found, sums)));
                              squares_[i] += float(sums.squares);
                              sums.by_group.move_to(&flux_[i * image.groups]);
                              if (!part_flux_.empty())
                                  sums.parts.move_to(&part_flux_[i * kPhotonParts]);
                              if (!inner_flux_.empty()) sums.inner.move_to(&inner_flux_[i]);
                          }
                          gathered.fetch_add(sums.photons, std::memory_order_relaxed);
                          rays.fetch_add(sums.rays, std::memory_order_relaxed);
                      });
    gathered_ += gathered.load();
    rays_ += rays.load();
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
    return beam.throughput * density;
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
    if (boundary_) boundary_->state(archive);
}

std::size_t VolumeGather::memory_bytes() const {
    return (waiting_.capacity() + photons_.capacity()) * sizeof(VolumePhoton) +
           positions_.capacity() * sizeof(Vec3) + grid_.memory_bytes() +
           (flux_.capacity() + part_flux_.capacity() + inner_flux_.capacity()) * sizeof(Rgb) +
           squares_.capacity() * sizeof(float) + (boundary_ ? boundary_->memory_bytes() : 0);
}

std::size_t VolumeGather::memory_bound_bytes(const Scene& scene, std::size_t eye_paths,
                                             std::size_t iteration) {
    const std::size_t photons = kWaitingPhotons + iteration;
    return kVectorGrowth * (2 * photons + iteration) * sizeof(VolumePhoton) +
           kVectorGrowth * photons * sizeof(Vec3) + SegmentGrid::memory_bound_bytes(photons) +
           eye_paths * (scene.light_groups() * sizeof(Rgb) + sizeof(float)) +
           BeamBoundary::memory_bound_bytes(eye_paths);
}

}  // namespace aips
