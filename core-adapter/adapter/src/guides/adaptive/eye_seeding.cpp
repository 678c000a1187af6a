// Walks from visible points to the lights, in blocks that are joined in order.
#include "guides/adaptive/eye_seeding.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "aips/core/base/cache_line.h"
#include "aips/core/sampling/sampling.h"
#include "ranks/shared_work.h"

namespace aips {
namespace {

constexpr std::uint32_t kGroupsPerBlock = 128;

/// What all walks of a pass share.
struct SeedInput {
    const Scene& scene;
    const Settings& settings;
    const DiscreteDistribution& light_choice;
    const std::vector<LightIndex>& live_lights;  // those that light_choice may choose
    std::uint64_t pass = 0;
    float time = 0;
    const EyeImage& image;
};

struct alignas(kCacheLine) SeedBlock {
    std::vector<EmissionSeed> seeds;
    SeedCounts counts;
};

/// The visible point as a surface to leave. Its rounding error is not kept: a thousandth of a
/// pixel's footprint is beyond it and beneath notice.
SurfacePoint surface_at(const VisiblePoint& visible, float footprint) {
    const float error = 1e-3f * footprint;
    SurfacePoint point;
    point.position = visible.position;
    point.position_error = abs(visible.position) * 1e-6f + Vec3{error, error, error};
    point.geometric_normal = visible.geometric_normal;
    point.shading_normal = visible.shading_normal;
    point.bsdf = visible.bsdf;
    point.material = visible.material;
    return point;
}

bool same_side(const SurfacePoint& point, Vec3 a, Vec3 b) {
    return dot(point.geometric_normal, a) * dot(point.geometric_normal, b) > 0;
}

/// Whether light from wi can leave along wo; specular lobes count as if they were broad.
bool scatters(const SurfacePoint& point, Vec3 wo, Vec3 wi) {
    if (!point.bsdf) return same_side(point, wo, wi);
    if (point.bsdf->lobes() & kSpecular) return true;
    return !is_black(point.bsdf->evaluate(wo, wi, Transport::Radiance, kNonSpecular));
}

/// One walk.
class SeedWalk {
  public:
    SeedWalk(const SeedInput& input, RandomStream& random, Arena& arena, SeedBlock& block)
        : in_(input), random_(random), arena_(arena), block_(block) {}

    void run(const VisiblePoint& visible) {
        ++block_.counts.walks;
        last_ = surface_at(visible, static_cast<float>(in_.image.mean_footprint()));
        throughput_ =
            visible.throughput *
            (visible.bsdf ? visible.bsdf->albedo(visible.wo, visible.receiving) : visible.kd);
        if (!in_.settings.direct_light_sampling) connect(last_, visible.wo, throughput_);
        if (!leave_diffusely(visible.wo)) return;
        for (std::uint32_t bounce = 0; bounce <= kMaxSeedBounces; ++bounce) {
            if (!walk_on()) return;
        }
    }

  private:
    bool leave_diffusely(Vec3 wo) {
        const Vec3 n = same_side(last_, wo, last_.shading_normal) ? last_.shading_normal
                                                                  : -last_.shading_normal;
        const Vec3 d = Frame(n).to_world(square_to_cosine_hemisphere(random_.next2()));
        last_.bsdf = nullptr;
        ray_ = in_.scene.spawn(last_, d, in_.time);
        return same_side(last_, wo, d);
    }

    /// To the next surface, with its connections; false where the walk ends.
    bool walk_on() {
        arena_.reset();
        SurfacePoint hit;
        ++block_.counts.rays;
        if (!in_.scene.intersect(ray_, hit, arena_)) {
            if (bent_) seed_sky();
            return false;
        }
        throughput_ *= hit.transmittance;
        if (bent_ && hit.light != kNoLight) seed_emitter(hit);
        if (!hit.bsdf) return false;
        const Vec3 wo = -ray_.direction;
        const Rgb reflected = throughput_ * hit.bsdf->albedo(wo, kAllLobes);
        if (hit.bsdf->lobes() & kNonSpecular) {
            connect(hit, wo, reflected);
            return false;
        }
        return bounce(hit, wo, reflected);
    }

    bool bounce(const SurfacePoint& hit, Vec3 wo, Rgb reflected) {
        const Vec2 u = random_.next2();
        BsdfSample sample;
        if (!hit.bsdf->sample(wo, u, random_.next(), Transport::Radiance, kSpecular, sample)) {
            return false;
        }
        if (!sample.straight) {  // what passes straight arrives as from the light itself
            connect(hit, wo, reflected);
            bent_ = true;
            last_ = hit;
            last_.bsdf = nullptr;
        }
        throughput_ *= sample.weight;
        ray_ = continue_ray(in_.scene, hit, sample.wi, sample.component, ray_);
        return !is_black(throughput_);
    }

    struct ChosenLight {
        LightIndex index;
        float pdf;
    };
    /// Half by power and half alike: a light that others outshine a billion times may be the only
    /// one that reaches anything.
    ChosenLight choose_light() {
        const float u = 2 * random_.next();
        const auto& live = in_.live_lights;
        const auto count = static_cast<float>(live.size());
        const auto place = static_cast<std::size_t>(std::max(0.0f, u - 1) * count);
        const LightIndex index = u < 1 ? static_cast<LightIndex>(in_.light_choice.sample(u).index)
                                       : live[std::min(live.size() - 1, place)];
        return {index, 0.5f * (in_.light_choice.pdf(index) + 1 / count)};
    }

    /// Next-event estimation that takes the surface for a diffuse one of its albedo.
    void connect(const SurfacePoint& point, Vec3 wo, Rgb reflected) {
        const auto [light, choice_pdf] = choose_light();
        DirectSample sample;
        if (!in_.scene.lights()[light]->sample_direct(point, random_.next2(), sample) ||
            !(sample.pdf > 0) || !scatters(point, wo, sample.wi)) {
            return;
        }
        const float cosine = abs_dot(sample.wi, point.shading_normal);
        const Rgb arriving = sample.radiance * (cosine * kInvPi / (sample.pdf * choice_pdf));
        ++block_.counts.rays;
        const Rgb visible = in_.scene.visibility(point, sample, in_.time);
        seed(light, point, sample, reflected * arriving * visible);
    }

    void seed_emitter(const SurfacePoint& hit) {
        DirectSample sample;
        sample.wi = ray_.direction;
        sample.distance = length(hit.position - last_.position);
        sample.radiance = hit.emitted;
        sample.segment_end = hit.position;
        sample.primitive = hit.primitive;
        seed(hit.light, last_, sample, throughput_ * hit.emitted);
    }

    void seed_sky() {
        const auto lights = in_.scene.lights();
        DirectSample sample;
        sample.wi = ray_.direction;
        sample.distance = std::numeric_limits<float>::infinity();
        for (LightIndex i = 0; i < lights.size(); ++i) {
            if (!lights[i]->at_infinity()) continue;
            sample.radiance = lights[i]->escaped(ray_.direction);
            seed(i, last_, sample, throughput_ * sample.radiance);
        }
    }

    void seed(LightIndex light, const SurfacePoint& towards, const DirectSample& sample,
              Rgb value) {
        EmissionSeed found{light, {}, luminance(value)};
        if (!(found.weight > 0) || !std::isfinite(found.weight)) return;
        // Coordinates that do not matter stay spread out, so that they gather no density.
        for (double& u : found.point)
            u = double(random_.next());
        if (!in_.scene.lights()[light]->emission_coordinates(towards, sample, found.point)) return;
        for (const double u : found.point) {
            if (!(u >= 0 && u < 1)) return;
        }
        block_.seeds.push_back(found);
    }

    const SeedInput& in_;
    RandomStream& random_;
    Arena& arena_;
    SeedBlock& block_;

    Ray ray_;
    Rgb throughput_ = kWhite;
    SurfacePoint last_;  // where the walk last changed its direction
    bool bent_ = false;  // has it met a specular surface that did
};

void walk_block(const SeedInput& in, std::uint32_t first_group, std::uint32_t last_group,
                SeedBlock& block) {
    const auto& points = in.image.visible_points;
    const std::size_t own_first = in.image.owners.first(points.size());
    const std::size_t own_last = in.image.owners.last(points.size());
    Arena arena;
    for (std::uint32_t group = first_group; group < last_group; ++group) {
        RandomStream random(in.settings.seed, in.pass, group, RandomDomain::EyeSeeding);
        const std::size_t first = std::size_t(group) * kSeedGroup;
        const std::size_t count = std::min<std::size_t>(kSeedGroup, points.size() - first);
        const auto chosen = static_cast<std::size_t>(random.next() * static_cast<float>(count));
        if (first + chosen < own_first || first + chosen >= own_last) continue;
        if (!points[first + chosen].takes_gloss_alone())
            SeedWalk(in, random, arena, block).run(points[first + chosen]);
    }
}

/// Each rank walks from its own points, whose groups follow on those of the rank before.
void join_ranks(const PointOwners& owners, std::vector<EmissionSeed>& seeds, SeedCounts& counts) {
    if (!owners.ranks) return;
    SharedWork work = work_on_points(owners, nullptr);
    struct OfRank {
        std::vector<EmissionSeed> seeds;
        SeedCounts counts;
    };
    std::vector<OfRank> ranks(owners.ranks->count());
    ranks[owners.ranks->rank()] = {std::move(seeds), counts};
    work.exchange([&](std::uint32_t rank, StateArchive& archive) {
        state_of(archive, ranks[rank].seeds, ranks[rank].counts.walks, ranks[rank].counts.rays);
    });
    seeds.clear();
    counts = {};
    for (const OfRank& rank : ranks) {
        seeds.insert(seeds.end(), rank.seeds.begin(), rank.seeds.end());
        counts.walks += rank.counts.walks;
        counts.rays += rank.counts.rays;
    }
}

}  // namespace

void find_emission_seeds(const Scene& scene, const Settings& settings,
                         const DiscreteDistribution& light_choice, std::uint64_t pass, float time,
                         const EyeImage& image, std::vector<EmissionSeed>& seeds,
                         SeedCounts& counts) {
    seeds.clear();
    counts = {};
    if (light_choice.empty()) return;
    std::vector<LightIndex> live_lights;
    for (std::size_t i = 0; i < scene.lights().size(); ++i)
        if (light_choice.pdf(i) > 0) live_lights.push_back(static_cast<LightIndex>(i));
    const SeedInput input{scene, settings, light_choice, live_lights, pass, time, image};
    const auto groups =
        static_cast<std::uint32_t>((image.visible_points.size() + kSeedGroup - 1) / kSeedGroup);
    std::vector<SeedBlock> blocks((groups + kGroupsPerBlock - 1) / kGroupsPerBlock);
    tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t b) {
        const auto first = static_cast<std::uint32_t>(b) * kGroupsPerBlock;
        walk_block(input, first, std::min(groups, first + kGroupsPerBlock), blocks[b]);
    });
    for (const SeedBlock& block : blocks) {
        seeds.insert(seeds.end(), block.seeds.begin(), block.seeds.end());
        counts.walks += block.counts.walks;
        counts.rays += block.counts.rays;
    }
    join_ranks(image.owners, seeds, counts);
}

}  // namespace aips
