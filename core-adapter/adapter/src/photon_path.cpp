// One photon path. Weights are adjoint Bsdf * cosine / (density actually used), at every bounce.
#include "photon_path.h"

#include <cmath>
#include <limits>

#include "aips/core/primary_path.h"
#include "eye_pass.h"
#include "scatter_photon.h"

namespace aips {
namespace {

/// A photon between two surfaces.
struct Photon {
    Ray ray;
    Rgb power;
    Vec3 previous;  // where it last left a surface or the light
    std::uint32_t group = 0;
    bool straight = true;  // has met nothing but null surfaces and architectural glass
    EmissionStart start;
};

/// Four numbers for the light's coordinates, the fifth chooses the light.
template <class Numbers>
EmissionStart choose_start(const PhotonInput& in, Numbers& numbers) {
    const float u_light = in.scene.lights().size() > 1 ? numbers.emission(4) : 0.5f;
    const PrimaryPoint u{numbers.emission(0), numbers.emission(1), numbers.emission(2),
                         numbers.emission(3)};
    if (in.emission) return in.emission->sample(u_light, u);
    const DiscreteSample light = in.light_choice.sample(u_light);
    return {static_cast<LightIndex>(light.index), u, double(light.pdf)};
}

template <class Numbers>
bool emit(const PhotonInput& in, Numbers& numbers, Refusals& refusals, Photon& photon) {
    photon.start = choose_start(in, numbers);
    const Light& light = *in.scene.lights()[photon.start.light];
    Emission emission;
    if (!light.emit(photon.start.point, emission)) return false;
    photon.ray = emission.ray;
    photon.ray.time = in.time;
    photon.power = emission.power / float(photon.start.pdf);
    photon.previous = emission.ray.origin;
    photon.group = light.group();
    return refusals.accept(photon.power, kLightOrigin) && !is_black(photon.power);
}

void store_landing(const PhotonInput& in, const SurfacePoint& point, const Photon& photon,
                   std::uint32_t depth, std::uint32_t index, std::vector<Landing>& landings,
                   PhotonCounts& counts) {
    if (in.occupancy && !in.occupancy->near_visible_point(point.position)) return;
    if (in.reach && !in.reach->any_within_radius(point.position)) return;
    Landing landing;
    landing.position = point.position;
    landing.direction = -photon.ray.direction;
    landing.power = photon.power;
    landing.previous = photon.previous;
    landing.normal = point.geometric_normal;
    landing.depth = static_cast<std::uint16_t>(depth);
    landing.light_group = static_cast<std::uint16_t>(photon.group);
    landing.path = index;
    landings.push_back(landing);
    ++counts.landings;
}

/// By the power that is expected to leave, against the power at emission, so that photons keep
/// about equal power; before its limits.
float plain_survival(const SurfacePoint& point, const Photon& photon, float emitted_power) {
    const Rgb albedo = point.bsdf->albedo(-photon.ray.direction, kAllLobes);
    return max_component(photon.power * albedo) / emitted_power;
}

/// By what a photon may still bring; negative where nothing is known.
float scored_survival(const PhotonInput& in, const SurfacePoint& point, const Photon& photon) {
    return in.survival
        ->probability(point.position, normal_towards(-photon.ray.direction, point),
                      luminance(photon.power))
        .value_or(-1.0f);
}

/// Roulette, fixed before the direction is drawn. By score it goes with the root of both ways: what
/// is known of scores is noisy, and alone would end photons that matter (docs/design-notes.md).
Survival survival(const PhotonInput& in, const SurfacePoint& point, const Photon& photon,
                  float emitted_power, bool logged) {
    Survival s;
    s.plain = plain_survival(point, photon, emitted_power);
    if (in.survival && (logged || in.survive_by_score)) {
        s.scored = scored_survival(in, point, photon);
        if (s.scored >= 0) s.scored = std::sqrt(s.scored * s.plain);
    }
    s.probability = limited_survival(in.survive_by_score && s.scored >= 0 ? s.scored : s.plain);
    return s;
}

/// A path's record while it is traced: closed when the path ends, wherever that is.
class LogEntry {
  public:
    LogEntry(PathLog* log, bool vertices, const EmissionStart& start,
             const std::vector<Landing>& landings, const PhotonCounts& counts)
        : log_(log),
          vertices_(log && vertices),
          landings_(landings),
          counts_(counts),
          rays_before_(counts.rays) {
        if (!log_) return;
        PathRecord record;
        record.light = start.light;
        record.start = start.point;
        record.pdf = start.pdf;
        record.first_vertex = static_cast<std::uint32_t>(log_->vertices.size());
        record.first_landing = static_cast<std::uint32_t>(landings.size());
        log_->paths.push_back(record);
    }
    ~LogEntry() {
        if (!log_) return;
        PathRecord& record = log_->paths.back();
        record.vertices = static_cast<std::uint32_t>(log_->vertices.size()) - record.first_vertex;
        record.landings = static_cast<std::uint32_t>(landings_.size()) - record.first_landing;
        record.rays = rays();
    }
    LogEntry(const LogEntry&) = delete;
    LogEntry& operator=(const LogEntry&) = delete;

    bool has_vertices() const { return vertices_; }
    void add_vertex(const SurfacePoint& point, const Photon& photon, const Survival& survived,
                    std::uint32_t depth) const {
        if (!vertices_) return;
        PathVertex vertex;
        vertex.position = point.position;
        vertex.normal = normal_towards(-photon.ray.direction, point);
        vertex.power = luminance(photon.power) / survived.probability;
        vertex.survival = survived;
        vertex.rays = rays();
        vertex.depth = depth;
        log_->vertices.push_back(vertex);
    }

    /// How the photon, which came from wo, left the vertex added last. The density of what the Bsdf
    /// drew by itself is found here: but for the log nothing asks for it.
    void set_direction(const SurfacePoint& point, Vec3 wo, const ScatteredPhoton& scattered) const {
        if (!vertices_) return;
        PathVertex& vertex = log_->vertices.back();
        vertex.direction = scattered.direction;
        vertex.pdf = scattered.pdf;
        vertex.plain_pdf = scattered.plain_pdf;
        if (scattered.lobe & kNonSpecular) {
            vertex.pdf = vertex.plain_pdf = point.bsdf->pdf(wo, scattered.direction, kNonSpecular);
        }
        vertex.lobes = point.bsdf->lobes();
    }

  private:
    std::uint32_t rays() const { return static_cast<std::uint32_t>(counts_.rays - rays_before_); }

    PathLog* log_;
    bool vertices_;
    const std::vector<Landing>& landings_;
    const PhotonCounts& counts_;
    std::uint64_t rays_before_;
};

}  // namespace

PhotonCounts& PhotonCounts::operator+=(const PhotonCounts& o) {
    paths += o.paths;
    rays += o.rays;
    bounces += o.bounces;
    guided_bounces += o.guided_bounces;
    landings += o.landings;
    return *this;
}

template <class Numbers>
void trace_photon_path(const PhotonInput& in, Numbers& numbers, std::uint32_t index,
                       Refusals& refusals, Arena& arena, std::vector<Landing>& landings,
                       PhotonCounts& counts, PathLog* log) {
    ++counts.paths;
    Photon photon;
    const bool left_light = emit(in, numbers, refusals, photon);
    const LogEntry entry(log, in.log_vertices, photon.start, landings, counts);
    if (!left_light) return;
    float emitted_power = max_component(photon.power);
    const LobeMask receiving = receiving_lobes(in.settings);

    for (std::uint32_t depth = 1;; ++depth) {
        arena.reset();
        SurfacePoint point;
        ++counts.rays;
        if (!in.scene.intersect(photon.ray, point, arena) || !point.bsdf) return;
        photon.power *= point.transmittance;
        const bool owned_by_shadow_rays = photon.straight && in.settings.direct_light_sampling;
        if ((point.bsdf->lobes() & receiving) && !owned_by_shadow_rays) {
            store_landing(in, point, photon, depth, index, landings, counts);
        }
        if (depth >= in.settings.max_photon_depth) return;

        auto& random = numbers.bounce(depth);
        const Survival survived = survival(in, point, photon, emitted_power, entry.has_vertices());
        if (survived.probability < 1 && random.next() >= survived.probability) return;
        entry.add_vertex(point, photon, survived, depth);
        const std::uint64_t bounces = counts.bounces, guided_bounces = counts.guided_bounces;
        ScatteredPhoton scattered;
        const bool left =
            scatter_photon(in, point, -photon.ray.direction, random, arena, counts, scattered);
        if (in.bounces && counts.bounces > bounces) {
            in.bounces->count(point.position, counts.guided_bounces > guided_bounces);
        }
        if (!left) return;
        entry.set_direction(point, -photon.ray.direction, scattered);
        if (in.unguided_roulette && scattered.pdf > 0) {
            emitted_power = std::max(emitted_power * (scattered.plain_pdf / scattered.pdf),
                                     std::numeric_limits<float>::min());
        }
        photon.power = photon.power * scattered.weight / survived.probability;
        if (!refusals.accept(photon.power, point.material) || is_black(photon.power)) return;
        photon.straight = photon.straight && scattered.straight;
        photon.previous = point.position;
        photon.ray = in.scene.spawn(point, scattered.direction, in.time);
    }
}

template void trace_photon_path(const PhotonInput&, SequencePath&, std::uint32_t, Refusals&, Arena&,
                                std::vector<Landing>&, PhotonCounts&, PathLog*);
template void trace_photon_path(const PhotonInput&, PrimaryPath&, std::uint32_t, Refusals&, Arena&,
                                std::vector<Landing>&, PhotonCounts&, PathLog*);

}  // namespace aips
