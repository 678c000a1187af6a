// One photon path. Weights are adjoint Bsdf * cosine / (density actually used), at every bounce.
#include "photons/photon_path.h"

#include <cmath>
#include <limits>

#include "aips/adapter/media.h"
#include "eye/eye_pass.h"
#include "photons/constants.h"
#include "photons/path_log_entry.h"
#include "photons/photon_roulette.h"
#include "sample_filter/meet_surface.h"

namespace aips {
namespace {

template <class Numbers>
EmissionStart choose_start(const PhotonInput& in, Numbers& numbers) {
    const float u_light = in.scene.lights().size() > 1 ? numbers.light_choice() : 0.5f;
    const PrimaryPoint u = numbers.start();
    if (in.emission) return in.emission->sample(u_light, u);
    const DiscreteSample light = in.light_choice.sample(u_light);
    return {static_cast<LightIndex>(light.index), u, double(light.pdf)};
}

template <class Numbers>
bool emit(const PhotonInput& in, Numbers& numbers, InvalidSampleFilter& filter,
          PhotonState& photon) {
    photon.start = choose_start(in, numbers);
    const Light& light = *in.scene.lights()[photon.start.light];
    Emission emission;
    if (!light.emit(photon.start.point, emission)) return false;
    photon.ray = emission.ray;
    photon.ray.time = in.time;
    photon.power = emission.power / float(photon.start.pdf);
    photon.previous = emission.ray.origin;
    photon.group = light.group();
    photon.emitted_power = max_component(photon.power);
    const Origin origin = filter.of_light(photon.start.light);
    return filter.accept(photon.power, origin) &&
           filter.accept_direction(photon.ray.origin, origin) &&
           filter.accept_direction(photon.ray.direction, origin) && !is_black(photon.power);
}

/// The photons of one path: the one that the light emits, and those that it is split into.
template <class Numbers>
class PhotonTrace {
  public:
    PhotonTrace(const PhotonInput& in, Numbers& numbers, std::uint32_t index,
                InvalidSampleFilter& filter, Arena& arena, std::vector<Photon>& photons,
                std::vector<VolumePhoton>* collisions, PhotonCounts& counts)
        : in_(in),
          media_(collisions ? in.scene.media() : nullptr),
          numbers_(numbers),
          index_(index),
          filter_(filter),
          arena_(arena),
          photons_(photons),
          collisions_(collisions),
          counts_(counts),
          receiving_(receiving_lobes(in.settings)) {}

    /// Follows one photon to its end. `entry` may be null.
    void follow(PhotonState photon, const LogEntry* entry) {
        SurfacePoint point;
        while (land(photon, point)) {
            auto& random = numbers_.bounce(photon.depth);
            const bool split = splits_ < kMostSplits && photons_.size() < in_.split_limit;
            const Survival survived =
                decide_survival(in_, point, photon, entry && entry->has_vertices(), split);
            const std::uint32_t photons = draw_photons(survived, random);
            // Of a chain's path, which no other photon is split from and no medium scatters, a
            // bounce draws that number and those of one scattering.
            static_assert(1 + kScatterNumbers == kBounceCoordinates);
            if (photons == 0) return;
            if (entry) entry->add_vertex(point, photon, survived);
            for (std::uint32_t i = 1; i < photons; ++i) {
                PhotonState other = photon;
                if (leave(other, point, survived.photons, random, nullptr))
                    waiting_.push_back(other);
            }
            splits_ += photons - 1;
            counts_.split_off += photons - 1;
            if (!leave(photon, point, survived.photons, random, entry)) return;
        }
    }

    /// Follows those that wait.
    void follow_others() {
        while (!waiting_.empty()) {
            const PhotonState photon = waiting_.back();
            waiting_.pop_back();
            follow(photon, nullptr);
        }
    }

  private:
    /// Where the photon meets a surface; false if it ends there, or meets none.
    bool land(PhotonState& photon, SurfacePoint& point) {
        bool met = false;
        do {
            arena_.reset();
            point = {};
            ++counts_.rays;
            met = meet_surface(in_.scene, photon.ray, point, arena_, filter_);
        } while (media_ && media_->scatters(photon.ray.medium) && fly(photon, point));
        photon.power *= point.transmittance;
        if (!met) return false;
        const bool lives = point.bsdf && !is_black(photon.power);
        const PhotonFate fate = lives ? take(point, photon) : PhotonFate::Black;
        const LobeMask lobes = lives ? point.bsdf->lobes() : LobeMask{};
        const bool cut = lives && photon.at_end(in_.settings, lobes, lobes & kSpecular);
        if (in_.settings.transport_statistics) counts_.statistics.hit(point.material, fate, cut);
        return lives && !cut && (!photon.is_spent(in_.settings) || lobes & kSpecular);
    }

    /// Leaves a photon where the surface takes one.
    PhotonFate take(const SurfacePoint& point, const PhotonState& photon) {
        const LobeMask lobes = point.bsdf->lobes();
        const bool on_gloss =
            in_.settings.caustics_on_gloss && (lobes & kGlossy) && photon.part != ImagePart::Direct;
        if (!(lobes & receiving_) && !on_gloss) return PhotonFate::Specular;
        const bool owned_by_shadow_rays = photon.straight && in_.settings.direct_light_sampling;
        if (owned_by_shadow_rays && !in_.store_owned) return PhotonFate::Direct;
        const bool stored = store(point, photon, owned_by_shadow_rays);
        if (owned_by_shadow_rays) return PhotonFate::Direct;
        return stored ? PhotonFate::Stored : PhotonFate::Unseen;
    }

    /// Goes on through a medium that scatters; true if it was scattered there and goes elsewhere.
    /// Else it reaches `point`, or ends: then it has no power left.
    bool fly(PhotonState& photon, SurfacePoint& point) {
        auto& random = numbers_.bounce(photon.depth);
        const Flight flight = media_->sample_flight(photon.ray.medium, photon.ray, point.distance,
                                                    photon.power, random.next2());
        photon.power *= flight.weight;
        // Of both, one: the flight's weight stands for the transmittance.
        point.transmittance = kWhite;
        if (!flight.collides) return false;
        if (scatter_in_medium(photon, flight.distance, random)) return true;
        photon.power = {};
        return false;
    }

    /// Stores a collision and draws what becomes of the photon; false if it ends.
    template <class Random>
    bool scatter_in_medium(PhotonState& photon, float distance, Random& random) {
        const void* const medium = photon.ray.medium;
        const Vec3 position = photon.ray.origin + photon.ray.direction * distance;
        photon.power *= media_->scattering_at(medium, position);
        if (!filter_.accept(photon.power, kPassageOrigin)) return false;
        if (!photon.straight || !in_.settings.direct_light_sampling) {
            collisions_->push_back({position, -photon.ray.direction, photon.power,
                                    media_->alone(medium), photon.group, photon.part,
                                    std::min(photon.bounces, kMostPhotonBounces)});
        }
        if (photon.at_end(in_.settings, {}, false) || photon.is_spent(in_.settings)) return false;
        const float survival = std::min(1.0f, max_component(photon.power) / photon.emitted_power);
        if (!(random.next() < survival)) return false;
        const PhaseSample sample =
            media_->sample_phase(medium, photon.ray.direction, photon.power, random.next2());
        photon.power = photon.power * sample.weight / survival;
        if (!filter_.accept(photon.power, kPassageOrigin)) return false;
        photon.straight = false;
        photon.part = ImagePart::Indirect;
        photon.from_specular = false;
        photon.previous = position;
        photon.ray = {position, sample.direction, in_.time, medium, photon.ray.component};
        ++photon.bounces;
        photon.pass(in_.settings, {});
        return true;
    }

    /// False if nothing is seen near.
    bool store(const SurfacePoint& point, const PhotonState& photon, bool owned_by_shadow_rays) {
        if (in_.occupancy && !in_.occupancy->near_visible_point(point.position)) return false;
        if (in_.reach && !in_.reach->any_within_radius(point.position)) return false;
        Photon stored;
        stored.position = point.position;
        stored.direction = -photon.ray.direction;
        stored.power = photon.power;
        stored.previous = photon.previous;
        stored.normal = point.geometric_normal;
        stored.depth = static_cast<std::uint16_t>(std::min(photon.depth, kDeepestPhoton));
        stored.light_group = static_cast<std::uint16_t>(photon.group);
        stored.light = std::min<std::uint32_t>(photon.start.light, kLastLight);
        stored.bounces = std::min(photon.bounces, kMostPhotonBounces);
        stored.path = index_;
        stored.owned_by_shadow_rays = owned_by_shadow_rays;
        stored.from_specular = photon.from_specular;
        stored.shareable = photon.shareable;
        stored.part = static_cast<std::uint16_t>(photon.part);
        stored.found_alone = photon.part == ImagePart::Caustics &&
                             !eye_paths_meet(*in_.scene.lights()[photon.start.light], in_.settings);
        photons_.push_back(stored);
        if (!owned_by_shadow_rays) ++counts_.photons;
        return true;
    }

    /// A whole number, survived.photons on average.
    template <class Random>
    std::uint32_t draw_photons(const Survival& survived, Random& random) {
        if (survived.photons == 1) return 1;
        const auto whole = static_cast<std::uint32_t>(survived.photons);
        const float u = random.next();
        const std::uint32_t photons = whole + (u < survived.photons - float(whole) ? 1 : 0);
        const bool by_score = in_.score_mix != ScoreMix::None;
        if (photons == 0 && by_score && u < photons_going_on(survived, ScoreMix::None, 1)) {
            ++counts_.pruned;
        }
        return photons;
    }

    /// Draws the way that the photon, one of `photons` on average, takes from the surface; false if
    /// it is absorbed.
    template <class Random>
    bool leave(PhotonState& photon, const SurfacePoint& point, float photons, Random& random,
               const LogEntry* entry) {
        const std::uint64_t bounces = counts_.bounces, guided_bounces = counts_.guided_bounces;
        const Vec3 wo = -photon.ray.direction;
        ScatteredPhoton scattered;
        const bool left = scatter_photon(in_, point, wo, random, arena_, counts_, scattered);
        if (in_.bounces && counts_.bounces > bounces) {
            in_.bounces->count(point.position, counts_.guided_bounces > guided_bounces);
        }
        if (!left) return false;
        const LobeMask lobes = point.bsdf->lobes();
        if (!scattered.straight &&
            (photon.at_end(in_.settings, lobes, false) || photon.is_spent(in_.settings)))
            return false;
        if (entry) entry->set_direction(point, wo, scattered);
        if (in_.unguided_roulette && scattered.pdf > 0) {
            photon.emitted_power =
                std::max(photon.emitted_power * (scattered.plain_pdf / scattered.pdf),
                         std::numeric_limits<float>::min());
        }
        photon.power = photon.power * scattered.weight / photons;
        if (!filter_.accept(photon.power, point.material) || is_black(photon.power)) return false;
        if (!filter_.accept_direction(scattered.direction, point.material)) return false;
        if (photon.straight && !scattered.straight) photon.shareable = scattered.lobe != kSpecular;
        photon.straight = photon.straight && scattered.straight;
        if (!scattered.straight) {
            photon.part = scattered_on(photon.part, scattered.lobe == kSpecular);
            ++photon.bounces;
        }
        photon.from_specular = scattered.lobe == kSpecular;
        photon.previous = point.position;
        photon.ray =
            continue_ray(in_.scene, point, scattered.direction, scattered.component, photon.ray);
        photon.pass(in_.settings, lobes);
        return true;
    }

    const PhotonInput& in_;
    const Media* media_;  // null if no medium scatters
    Numbers& numbers_;
    std::uint32_t index_;
    InvalidSampleFilter& filter_;
    Arena& arena_;
    std::vector<Photon>& photons_;
    std::vector<VolumePhoton>* collisions_;
    PhotonCounts& counts_;
    LobeMask receiving_;
    std::vector<PhotonState> waiting_;  // split off, at their way's start
    std::uint32_t splits_ = 0;          // photons split off so far
};

}  // namespace

PhotonCounts& PhotonCounts::operator+=(const PhotonCounts& o) {
    paths += o.paths;
    guided_emissions += o.guided_emissions;
    rays += o.rays;
    bounces += o.bounces;
    guided_bounces += o.guided_bounces;
    photons += o.photons;
    split_off += o.split_off;
    pruned += o.pruned;
    statistics += o.statistics;
    return *this;
}

void PhotonCounts::state(StateArchive& archive) {
    for (std::uint64_t* count : {&paths, &guided_emissions, &rays, &bounces, &guided_bounces,
                                 &photons, &split_off, &pruned})
        archive.value(*count);
    statistics.state(archive);
}

template <class Numbers>
void trace_photon_path(const PhotonInput& in, Numbers& numbers, std::uint32_t index,
                       InvalidSampleFilter& filter, Arena& arena, std::vector<Photon>& photons,
                       PhotonCounts& counts, PathLog* log, std::vector<VolumePhoton>* collisions) {
    const std::uint64_t photons_before = counts.photons;
    const std::size_t collisions_before = collisions ? collisions->size() : 0;
    ++counts.paths;
    if (in.emission) ++counts.guided_emissions;
    PhotonState photon;
    const bool left_light = emit(in, numbers, filter, photon);
    PhotonTrace<Numbers> trace(in, numbers, index, filter, arena, photons, collisions, counts);
    {
        const LogEntry entry(log, in.log_vertices, photon.start, photons, counts);
        if (left_light) trace.follow(photon, log ? &entry : nullptr);
    }
    trace.follow_others();
    if (!in.settings.transport_statistics) return;
    const bool counted =
        counts.photons > photons_before || (collisions && collisions->size() > collisions_before);
    counts.statistics.path(photon.start.light, counted);
}

template void trace_photon_path(const PhotonInput&, SequencePath&, std::uint32_t,
                                InvalidSampleFilter&, Arena&, std::vector<Photon>&, PhotonCounts&,
                                PathLog*, std::vector<VolumePhoton>*);
template void trace_photon_path(const PhotonInput&, PrimaryPath&, std::uint32_t,
                                InvalidSampleFilter&, Arena&, std::vector<Photon>&, PhotonCounts&,
                                PathLog*, std::vector<VolumePhoton>*);

}  // namespace aips
